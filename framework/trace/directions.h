#pragma once

#include "framework/math/spread.h"
#include "framework/math/vec.h"

#include <numbers>

namespace luch {

/// Three unit vectors at right angles, z given (Duff et al., "Building an Orthonormal Basis,
/// Revisited", 2017).
struct Frame3 {
    Vec3d x, y, z;

    explicit Frame3(const Vec3d& unit_z) : z(unit_z) {
        const double sign = std::copysign(1.0, z.z);
        const double a = -1 / (sign + z.z);
        const double b = z.x * z.y * a;
        x = {1 + sign * z.x * z.x * a, sign * b, -sign * z.x};
        y = {b, sign + z.y * z.y * a, -z.y};
    }
    [[nodiscard]] Vec3d world(const Vec3d& local) const {
        return local.x * x + local.y * y + local.z * z;
    }
};

/// A direction around a normal with density cos/π: a point of the disc, lifted (Malley's method).
[[nodiscard]] inline Vec3d sample_cosine(const Vec3d& normal, const Vec2d& square) {
    const Vec2d disc = disc_of(square);
    const double height = std::sqrt(std::max(0.0, 1 - glm::dot(disc, disc)));
    return glm::normalize(Frame3(normal).world({disc.x, disc.y, height}));
}

/// Its density, over solid angle.
[[nodiscard]] inline double cosine_pdf(double cosine) {
    return cosine > 0 ? cosine / std::numbers::pi : 0;
}

/// A direction around an axis with density (n + 1)/2π · cosⁿ (Lafortune and Willems, "Using the
/// Modified Phong Reflectance Model for Physically Based Rendering", 1994).
[[nodiscard]] inline Vec3d sample_power_cosine(const Vec3d& axis, double exponent,
                                               const Vec2d& square) {
    const double turn = 2 * std::numbers::pi * square.x;
    // cos = u^(1/(n+1)); by logarithms, so that 1 − cos² keeps its digits for large n.
    const double log_cosine = std::log1p(-square.y) / (exponent + 1);
    const double cosine = std::exp(log_cosine);
    const double sine = std::sqrt(-std::expm1(2 * log_cosine));
    return glm::normalize(
        Frame3(axis).world({sine * std::cos(turn), sine * std::sin(turn), cosine}));
}

[[nodiscard]] inline double power_cosine_pdf(double cosine, double exponent) {
    if (!(cosine > 0)) return 0;
    // A cosine that rounding made larger than 1 is infinite to a large power.
    return (exponent + 1) / (2 * std::numbers::pi) * std::pow(std::min(cosine, 1.0), exponent);
}

}  // namespace luch
