#pragma once

#include "framework/math/ray.h"
#include "framework/scene/geometry.h"

#include <optional>

// The shapes that are not triangles: one scalar function in double each, called by all paths.
// The ray is in the shape's own coordinates; the nearest t with t_min < t < t_max is returned.
namespace luch {

struct ShapeHit {
    double t;
    std::uint32_t primitive;  ///< face of a cube: 2·axis + (1 on the positive side); else 0
};

std::optional<ShapeHit> intersect(const Plane& plane, const Ray& ray);
std::optional<ShapeHit> intersect(const Sphere& sphere, const Ray& ray);
std::optional<ShapeHit> intersect(const Cube& cube, const Ray& ray);

}  // namespace luch
