#pragma once

#include "framework/accel/hit.h"
#include "framework/math/simd.h"

#include <bit>

// The triangle test of hit.h in lanes: the same operations in the same order, so the same bits.
// What it cannot decide within its own, wider bounds it leaves to intersect_triangle().
// Only kernel files include this; nothing here has linkage.
namespace luch::wide {
namespace {

using simd::Lanes;

inline constexpr float infinite = std::numeric_limits<float>::infinity();

template <class T>
struct Three {
    T x, y, z;
};
template <class T>
Three(T, T, T) -> Three<T>;

template <class A, class B>
LUCH_INLINE auto minus(const Three<A>& a, const Three<B>& b) {
    return Three{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
LUCH_INLINE Three<T> cross(const Three<T>& a, const Three<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class A, class B>
LUCH_INLINE auto dot(const Three<A>& a, const Three<B>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
LUCH_INLINE T sum_of_sizes(const Three<T>& a) {
    using std::abs;
    return abs(a.x) + abs(a.y) + abs(a.z);
}
LUCH_INLINE float sum_of_sizes(const Vec3& v) {
    return sum_of_sizes(Three<float>{v.x, v.y, v.z});
}
/// The largest |component|; components that are NaN are passed over.
template <class T>
LUCH_INLINE T largest(const Three<T>& a, const T& so_far) {
    return max_or(abs(a.x), max_or(abs(a.y), max_or(abs(a.z), so_far)));
}
template <class T>
LUCH_INLINE Three<T> lower(const Three<T>& a, const Three<T>& b) {
    return {min_or(a.x, b.x), min_or(a.y, b.y), min_or(a.z, b.z)};
}
template <class T>
LUCH_INLINE Three<T> upper(const Three<T>& a, const Three<T>& b) {
    return {max_or(a.x, b.x), max_or(a.y, b.y), max_or(a.z, b.z)};
}

/// Denormal numbers among sixteen become ±0, as in object_ray().
LUCH_INLINE void drop_denormals(float* sixteen) {
    constexpr float normal = std::numeric_limits<float>::min();
    unsigned tiny = abs(Lanes<16>::load(sixteen)) < Lanes<16>(normal);
    for (; tiny != 0; tiny &= tiny - 1) {
        float& x = sixteen[std::countr_zero(tiny)];
        x = normal_or_zero(x);
    }
}

/// Above this, |(a × (b − a)) · d| in float has a certain sign, and hit.cpp finds the same one. No
/// component of a and b exceeds `size`, none of b − a `edge`, and `sum` is the sum of |components|
/// of d: the error is at most 6u · 2 · size · edge · sum (five roundings and that of b − a), the
/// bound allows 8u. What is left over, with the term in size², exceeds the bound in double of
/// certain_triple_product(), 2⁻⁵⁰ · 2 · size² · sum. The last term is for underflow, the thousandth
/// for the rounding of the bound itself.
/// The terms that hold 2⁻²² cover what rounding makes of edges between corners taken relative to
/// the origin; a hundredth is for size_of(), too.
inline constexpr float relative_bound = 1.01f * 16 * 0x1p-24f;
inline constexpr float smallest_bound = 9 * std::numeric_limits<float>::min();
/// No component of a triangle's corners relative to the origin is larger, but for rounding.
template <class T>
LUCH_INLINE T size_of(const Three<T>& corner, const T& edge) {
    return max_or(abs(corner.x), max_or(abs(corner.y), max_or(abs(corner.z), T(0.0f)))) + edge;
}
template <class A, class S>
LUCH_INLINE auto sign_bound(const A& size, const A& edge, const S& sum) {
    // Infinite where any product of the value may overflow: the small factor comes last.
    return size * (edge + size * 0x1p-22f) * (sum * 8.0f) * (0.125f * relative_bound) +
           (sum + 1.0f) * smallest_bound;
}

}  // namespace
}  // namespace luch::wide
