#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace luch {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec2d = glm::dvec2;
using Vec3d = glm::dvec3;

/// The largest of |x|, |y|, |z|.
template <class V>
[[nodiscard]] auto max_norm(const V& v) {
    // glm::abs would branch on the signs.
    return std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z)));
}

/// True when no component is NaN or infinite.
template <class V>
[[nodiscard]] bool all_finite(const V& v) {
    return v.x * 0 + v.y * 0 + v.z * 0 == 0;
}

}  // namespace luch
