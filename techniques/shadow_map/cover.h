#pragma once

#include "techniques/shadow_map/cube.h"

#include <vector>

namespace luch::techniques::shadow_map {

/// Texels x0 ≤ x < x1 of a row.
struct Run {
    int y, x0, x1;
};

/// A convex polygon in the coordinates of a face, seen from the light: (along the face's x, along
/// its y, along what it looks along).
using FacePolygon = std::span<const Vec3d>;

/// The texels of a face that a convex polygon may be seen through, when what is really there is up
/// to `pad` away from it in each coordinate (rounding): over the whole texel, not just its centre,
/// so that what is thinner than a texel is not lost. Replaces `runs`. False where the polygon comes
/// so close to the light that it may be seen anywhere.
bool cover(FacePolygon polygon, double pad, int n, const Tile& window, std::vector<Run>& runs);

}  // namespace luch::techniques::shadow_map
