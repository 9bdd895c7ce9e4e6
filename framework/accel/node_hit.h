#pragma once

#include "framework/accel/csg_hit.h"

#include <type_traits>

namespace luch {

/// Whether a ray can hit anything: it looks for some t, is finite, and has a direction (one of
/// denormal numbers is none, as processors may take them for 0).
[[nodiscard]] inline bool is_sound(const Ray& ray) {
    return ray.t_min < ray.t_max && all_finite(ray.origin) && all_finite(ray.direction) &&
           max_norm(ray.direction) >= std::numeric_limits<double>::min();
}

/// A node's transform of a world-space ray: the one function that all paths use.
[[nodiscard]] inline Ray to_object(const Ray& ray, const Node& node) {
    return node.to_object.ray(ray);
}

/// A ray in a shape's coordinates as its functions in double want it: what is below 2⁻⁵⁰⁰ in origin
/// and direction is ±0. So no product of two of its numbers is denormal (some processors are told
/// to take those for 0), and no time at which it meets a line of a heightfield is infinite.
[[nodiscard]] inline Ray shape_ray(Ray ray) {
    for (int axis = 0; axis < 3; ++axis) {
        for (double* x : {&ray.origin[axis], &ray.direction[axis]}) {
            if (std::abs(*x) < 0x1p-500) *x = std::copysign(0.0, *x);
        }
    }
    return ray;
}

/// The hit that a search starts with: nothing yet, nothing at or beyond t_max wanted.
[[nodiscard]] inline Hit no_hit_before(const Ray& ray) {
    return {.t = ray.t_max};
}

/// Meets a shape that is neither a mesh nor a solid.
template <class Shape>
std::optional<Hit> hit_of(const Shape& shape, const Ray& ray, WorkCounts& work) {
    std::optional<ShapeHit> found;
    if constexpr (std::is_same_v<Shape, Heightfield>) {
        found = intersect(shape, ray, work);
    } else {
        ++work.primitives;
        found = intersect(shape, ray);
    }
    if (!found) return std::nullopt;
    return Hit{static_cast<float>(found->t), 0, 0, no_node, found->primitive};
}

/// Improves `best` with a geometry that is no mesh; `in_its` is the ray in its coordinates.
/// `in_mesh` is what intersect() of a solid needs.
template <class InMesh>
void improve_with_shape(const Scene& scene, GeometryId geometry, const Ray& in_its, NodeId node,
                        Hit& best, WorkCounts& work, InMesh&& in_mesh) {
    const Ray ray = shape_ray(in_its);
    const auto meet = [&](const auto& shape) -> std::optional<Hit> {
        using Shape = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<Shape, Mesh>) {
            return std::nullopt;
        } else if constexpr (std::is_same_v<Shape, Csg>) {
            return intersect(shape, scene.geometries, ray, work, in_mesh);
        } else {
            return hit_of(shape, ray, work);
        }
    };
    std::optional<Hit> hit = std::visit(meet, scene.geometries[geometry]);
    if (!hit) return;
    hit->node = node;
    if (nearer(*hit, best)) best = *hit;
}

}  // namespace luch
