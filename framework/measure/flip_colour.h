#pragma once

#include "framework/math/colour.h"

#include <cmath>

// The colour spaces of FLIP: Andersson et al. 2020, sections 4.1 and 4.2. D65 throughout.
namespace luch::flip {

/// CIE XYZ of the display's white, linear RGB (1, 1, 1).
inline constexpr Vec3 white{0.950428545f, 1.0f, 1.088900371f};

/// XYZ relative to the white point, of linear sRGB; the matrix that IEC 61966-2-1's primaries give.
[[nodiscard]] inline Vec3 relative_xyz(const Rgb& c) {
    constexpr Vec3 to_x(10135552 / 24577794.0, 8788810 / 24577794.0, 4435075 / 24577794.0);
    constexpr Vec3 to_y(2613072 / 12288897.0, 8788810 / 12288897.0, 887015 / 12288897.0);
    constexpr Vec3 to_z(1425312 / 73733382.0, 8788810 / 73733382.0, 70074185 / 73733382.0);
    return Vec3(glm::dot(to_x, c), glm::dot(to_y, c), glm::dot(to_z, c)) / white;
}

/// Y, Cx, Cz: the linear version of CIELAB that the eye's spatial filters are measured in.
[[nodiscard]] inline Vec3 opponent(const Rgb& linear) {
    const Vec3 v = relative_xyz(linear);
    return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}

/// Back to linear RGB.
[[nodiscard]] inline Rgb linear_of(const Vec3& opponent) {
    const float y = (opponent.x + 16) / 116;
    const Vec3 v = Vec3(y + opponent.y / 500, y, y - opponent.z / 200) * white;
    return {3.241003275f * v.x - 1.537398934f * v.y - 0.498615861f * v.z,
            -0.969224334f * v.x + 1.875930071f * v.y + 0.041554224f * v.z,
            0.055639423f * v.x - 0.204011202f * v.y + 1.057148933f * v.z};
}

/// The curve of CIELAB: a cube root with a straight start.
[[nodiscard]] inline float lab_curve(float t) {
    constexpr float knee = 6.0f / 29;
    return t > knee * knee * knee ? std::cbrt(t) : t / (3 * knee * knee) + 4.0f / 29;
}

/// CIELAB after Hunt's effect: colourfulness falls with luminance, a and b are scaled by L/100.
[[nodiscard]] inline Vec3 hunt_lab(const Rgb& linear) {
    const Vec3 v = relative_xyz(linear);
    const float x = lab_curve(v.x), y = lab_curve(v.y), z = lab_curve(v.z);
    const float lightness = 116 * y - 16;
    return {lightness, 0.01f * lightness * 500 * (x - y), 0.01f * lightness * 200 * (y - z)};
}

/// The distance of two colours that are far apart (Abasi, Tehran and Fairchild 2020): city block
/// between lightness and chroma, Euclidean within chroma.
[[nodiscard]] inline float hyab(const Vec3& p, const Vec3& q) {
    const Vec3 off = p - q;
    return std::abs(off.x) + std::sqrt(off.y * off.y + off.z * off.z);
}

}  // namespace luch::flip
