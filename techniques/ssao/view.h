#pragma once

#include "techniques/ssao/ssao.h"

// What the passes share.
namespace luch::techniques::ssao {

/// Pixels that a unit across the view axis spans at distance 1.
struct Scale {
    float x, y;
    explicit Scale(const Screen& screen)
        : x(static_cast<float>(screen.size().width / (2 * screen.half_width()))),
          y(static_cast<float>(screen.size().height / (2 * screen.half_height()))) {}
    /// Of a length at depth z.
    [[nodiscard]] float px(float length, float z) const { return length / z * std::max(x, y); }
};

/// A normal that faces away from the eye is turned just so far that the surface is seen edge on;
/// zero where it faces straight away.
[[nodiscard]] inline Vec3 towards(const Vec3& to_eye, const Vec3& normal) {
    const float cosine = glm::dot(normal, to_eye);
    if (cosine >= 0) return normal;
    const Vec3 edge_on = normal - cosine * to_eye;
    const float length = glm::length(edge_on);
    return length > 1e-6f ? edge_on / length : Vec3(0);
}

/// Which of the 16 turns a pixel takes: another for each of 4 × 4.
[[nodiscard]] inline int turn_of(int x, int y) {
    return (x + y) % 4 * 4 + x % 4;
}

/// Whether what is seen at a height above the tangent plane of a point at depth z, and at a
/// distance from it, is there for certain: higher than least_sine of its distance, and than what
/// depths are rounded by.
[[nodiscard]] inline bool stands_out(float height, float distance_squared, float z) {
    return height > 0x1p-18f * z && height * height > least_sine * least_sine * distance_squared;
}

/// How far from the pixel's tangent plane another position lies.
[[nodiscard]] inline float off_plane(const GBuffer& seen, int x, int y, const Vec3& other) {
    return std::abs(glm::dot(seen.normal(x, y), other - seen.position(x, y)));
}

/// 1 on the plane, falling to 0 at the tolerance.
[[nodiscard]] inline float nearness(float off, float tolerance) {
    return std::max(0.0f, 1 - off / tolerance);
}

/// Calls at(x, y) for the pixels of a tile.
template <class At>
void each_pixel(Tile tile, At&& at) {
    for (int row = tile.y0; row < tile.y1; ++row) {
        for (int column = tile.x0; column < tile.x1; ++column) at(column, row);
    }
}

}  // namespace luch::techniques::ssao
