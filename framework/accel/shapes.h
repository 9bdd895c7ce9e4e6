#pragma once

#include "framework/accel/crossings.h"
#include "framework/math/ray.h"
#include "framework/scene/geometry.h"

#include <optional>

// The shapes that are not triangles: one scalar function in double each, called by all paths.
// The ray is in the shape's own coordinates; the nearest t with t_min < t < t_max is returned.
// Heightfields and solids have headers of their own.
namespace luch {

/// Whether a t counts, judged by the float that will be kept.
[[nodiscard]] inline bool within(double t, const Ray& ray) {
    const auto kept = static_cast<float>(t);
    return kept > least_t(ray.t_min) && kept < ray.t_max;
}

struct ShapeHit {
    double t;
    std::uint32_t primitive;  ///< face of a cube: 2·axis + (1 on the positive side); else 0
};

std::optional<ShapeHit> intersect(const Plane& plane, const Ray& ray);
std::optional<ShapeHit> intersect(const Sphere& sphere, const Ray& ray);
std::optional<ShapeHit> intersect(const Cube& cube, const Ray& ray);

// All places where a ray passes through the surface, for solids; the same t as above.
void find_crossings(const Plane& plane, const Ray& ray, Crossings& crossings);
void find_crossings(const Sphere& sphere, const Ray& ray, Crossings& crossings);
void find_crossings(const Cube& cube, const Ray& ray, Crossings& crossings);

}  // namespace luch
