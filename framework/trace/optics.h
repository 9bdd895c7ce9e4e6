#pragma once

#include "framework/math/vec.h"

#include <cmath>
#include <optional>

namespace luch {

/// A direction after a mirror; `normal` of unit length, on either side.
[[nodiscard]] inline Vec3d mirrored(const Vec3d& direction, const Vec3d& normal) {
    return direction - 2 * glm::dot(direction, normal) * normal;
}

/// A unit direction after a clear surface, by Snell's law; `normal` is turned against it, and
/// `ratio` is the index of refraction that it comes from over the one that it goes to. Nothing when
/// the reflection is total.
[[nodiscard]] inline std::optional<Vec3d> refracted(const Vec3d& direction, const Vec3d& normal,
                                                    double ratio) {
    const double cosine = -glm::dot(direction, normal);
    const double square = 1 - ratio * ratio * (1 - cosine * cosine);
    if (!(square >= 0)) return std::nullopt;
    return glm::normalize(ratio * direction + (ratio * cosine - std::sqrt(square)) * normal);
}

}  // namespace luch
