#pragma once

#include "framework/accel/accelerator.h"

namespace luch {

/// Whether a ray can hit anything: finite, and with a direction.
[[nodiscard]] inline bool is_sound(const Ray& ray) {
    return all_finite(ray.origin) && all_finite(ray.direction) && ray.direction != Vec3d(0);
}

/// A node's transform of a world-space ray: the one function that all paths use.
[[nodiscard]] inline Ray to_object(const Ray& ray, const Node& node) {
    return node.to_object.ray(ray);
}

/// The hit that a search starts with: nothing yet, nothing at or beyond t_max wanted.
[[nodiscard]] inline Hit no_hit_before(const Ray& ray) {
    return {.t = ray.t_max};
}

/// Improves `best` with a shape that is no mesh; `ray` in the shape's coordinates.
template <class Shape>
bool improve_with_shape(const Shape& shape, const Ray& ray, NodeId node, Hit& best) {
    const auto found = intersect(shape, ray);
    if (!found) return false;
    const Hit hit{static_cast<float>(found->t), 0, 0, node, found->primitive};
    if (!nearer(hit, best)) return false;
    best = hit;
    return true;
}

}  // namespace luch
