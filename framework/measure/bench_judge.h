#pragma once

#include "framework/math/ray.h"
#include "framework/scene/geometry.h"

#include <vector>

// Who is right when two back ends disagree about a ray: every triangle in double, for the ray and
// for those about it. Slow, for the few rays that they disagree about.
namespace luch {

/// `doubtful`: of the ray and those within float's rounding of it some hit and some miss (at the
/// rim of what is seen, or where a surface meets an end of the ray at a grazing angle). Rays
/// through the edges inside a closed surface are not: all of them hit.
enum class Verdict { miss, doubtful, hit };

struct Judgement {
    Verdict verdict = Verdict::miss;
    /// The triangles that may be the nearest, as far as these rays tell.
    std::vector<std::uint32_t> nearest;
};

/// `scale`: of the mesh's corners. Backfaces count.
Judgement judged(const Mesh& mesh, double scale, const Ray& ray);

}  // namespace luch
