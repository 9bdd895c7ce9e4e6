#pragma once

#include "framework/math/vec.h"

#include <array>
#include <cmath>
#include <numbers>

// Real spherical harmonics to degree 2. They are written in x, y and z, so they need no angles and
// do not care that the world is left-handed.
namespace luch::techniques::sh_ambient {

inline constexpr int sh_terms = 9;

/// Y_lm of a unit vector, at index l(l + 1) + m. Orthonormal over the sphere (R. Ramamoorthi and P.
/// Hanrahan, "An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001, eq. 3).
template <class V>
[[nodiscard]] std::array<typename V::value_type, sh_terms> harmonics(const V& n) {
    using T = typename V::value_type;
    constexpr T y0 = T(0.28209479177387814);                                 // √(1/4π)
    constexpr T y1 = T(0.48860251190291992);                                 // √(3/4π)
    constexpr T y2 = T(1.09254843059207907);                                 // √(15/4π)
    constexpr T y20 = T(0.31539156525252005), y22 = T(0.54627421529603959);  // √(5/16π), √(15/16π)
    return {y0,
            y1 * n.y,
            y1 * n.z,
            y1 * n.x,
            y2 * n.x * n.y,
            y2 * n.y * n.z,
            y20 * (3 * n.z * n.z - 1),
            y2 * n.x * n.z,
            y22 * (n.x * n.x - n.y * n.y)};
}

[[nodiscard]] constexpr int degree_of(int term) {
    return term == 0 ? 0 : term < 4 ? 1 : 2;
}

/// What a clamped cosine makes of a term of degree l: A_l = π, 2π/3, π/4 (ibid., eq. 8).
inline constexpr std::array<double, 3> cosine_lobe{std::numbers::pi, 2 * std::numbers::pi / 3,
                                                   std::numbers::pi / 4};

}  // namespace luch::techniques::sh_ambient
