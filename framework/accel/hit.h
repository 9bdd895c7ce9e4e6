#pragma once

#include "framework/math/bounds.h"
#include "framework/math/ray.h"

#include <limits>

// What a hit is: a function of ray and primitive, never of the path that found it. Every path
// (single ray, packet, raster, another library) is a filter in front of the functions in this file:
// it may keep too much, it never loses a candidate. closest_brute() in accelerator.h is the oracle.
namespace luch {

/// ±0 for a denormal number, which some processors are told to take for that.
[[nodiscard]] inline float normal_or_zero(float x) {
    return std::abs(x) < std::numeric_limits<float>::min() ? std::copysign(0.0f, x) : x;
}

/// A ray in the frame of a mesh, rounded to float once, without denormal numbers in origin and
/// direction. All paths make it with object_ray().
struct ObjectRay {
    Vec3 origin;
    Vec3 direction;
    Vec3 inverse;  ///< 1/direction, by components; ±infinity where that is ±0, ±0 above 2¹⁰⁰
    float t_min;
    float t_max;
};

/// `ray` must already be in the mesh's frame (Node::to_object), in double. With a component of the
/// direction above 2¹⁰⁰ it misses all meshes: its t would be near to denormal numbers, which some
/// processors are told to take for 0.
ObjectRay object_ray(const Ray& ray);

/// The t for which a ray is inside a box; a miss when near > far.
struct Interval {
    float near;
    float far;
};

/// 1 + 2γ₃, γ₃ = 3u/(1 − 3u), u = 2⁻²⁴: the far side of a slab is pushed out by the rounding that
/// both sides may have suffered (Ize, "Robust BVH Ray Traversal", 2013).
inline constexpr float far_padding = 1 + 2 * (3 * 0x1p-24f) / (1 - 3 * 0x1p-24f);

/// The one slab formula. Nested boxes give nested intervals exactly, since every operation is
/// monotonic. A ray that runs in a face (0 · ∞ = NaN) counts as inside: comparisons with NaN are
/// false and keep the old bound.
[[nodiscard]] inline Interval slab(const Box& box, const ObjectRay& ray) {
    Interval in{-std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        const bool negative = std::signbit(ray.direction[axis]);
        const float first = negative ? box.hi[axis] : box.lo[axis];
        const float last = negative ? box.lo[axis] : box.hi[axis];
        const float near = (first - ray.origin[axis]) * ray.inverse[axis];
        float far = (last - ray.origin[axis]) * ray.inverse[axis];
        far = far > 0 ? far * far_padding : far;
        if (near > in.near) in.near = near;
        if (far < in.far) in.far = far;
    }
    return in;
}

/// The sign of (a × b) · d: in float when the value exceeds its rounding bound, else in double,
/// else 0. A sign that is not zero is never wrong.
int edge_sign(const Vec3& a, const Vec3& b, const Vec3& d);

/// t, u, v of a triangle that was hit.
struct TriangleHit {
    float t, u, v;
};

/// The weights of a triangle's second and third corner, from the three values (a × b) · d of its
/// edges; 0 where they cannot be said.
struct Barycentric {
    float u, v;
};
[[nodiscard]] inline Barycentric barycentric(float weight0, float weight1, float weight2) {
    const auto share = [](float part, float whole, float limit) {
        const float ratio = part / whole;
        return ratio > 0 ? std::min(ratio, limit) : 0;
    };
    const float whole = weight0 + weight1 + weight2;
    const float u = share(weight1, whole, 1);
    return {u, share(weight2, whole, 1 - u)};
}

/// The one triangle test. A hit unless two edge signs are opposite (0 counts for both neighbours),
/// so no ray slips between triangles that share an edge or a corner; n · d = 0 is a miss. t is
/// clamped to the slab interval of the triangle's own box. A hit needs t_min < t < t_max. Returns
/// false on a miss and leaves `hit` alone. `cull_backfaces` skips triangles with n · d > 0.
bool intersect_triangle(const ObjectRay& ray, const Vec3& p0, const Vec3& p1, const Vec3& p2,
                        bool cull_backfaces, TriangleHit& hit);

}  // namespace luch
