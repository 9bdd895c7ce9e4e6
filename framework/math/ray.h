#pragma once

#include "framework/math/vec.h"

#include <cstdint>
#include <limits>

namespace luch {

/// A ray in world or object space: the points origin + t · direction with t_min < t < t_max.
/// The direction need not be of unit length; t is measured in its lengths, and is the same number
/// in every space that the ray is transformed to.
struct Ray {
    Vec3d origin{0};
    Vec3d direction{0, 0, 1};
    float t_min = 0;
    float t_max = std::numeric_limits<float>::infinity();

    [[nodiscard]] Vec3d at(double t) const { return origin + t * direction; }
};

/// What the t of a hit must exceed on a ray with that t_min. Below the least normal number t counts
/// as 0, so that the hits are the same where a processor takes denormal numbers for 0.
[[nodiscard]] inline float least_t(float t_min) {
    constexpr float normal = std::numeric_limits<float>::min(), largest_denormal = 0x1.fffffcp-127f;
    return std::abs(t_min) < normal ? largest_denormal : t_min;
}

/// Index of a node in Scene::nodes; `no_node` means none.
using NodeId = std::uint32_t;
inline constexpr NodeId no_node = ~NodeId{0};

/// What a ray met. Nothing but these five numbers is needed to shade it.
struct Hit {
    float t = std::numeric_limits<float>::infinity();
    float u = 0;  ///< barycentric weight of a triangle's second corner, else 0
    float v = 0;  ///< barycentric weight of a triangle's third corner, else 0
    NodeId node = no_node;
    std::uint32_t primitive = 0;  ///< triangle of a mesh, face of a cube, else 0

    [[nodiscard]] explicit operator bool() const { return node != no_node; }
    bool operator==(const Hit&) const = default;
};

/// The rule of the nearest hit: least (t, node, primitive), lexicographic.
[[nodiscard]] inline bool nearer(const Hit& a, const Hit& b) {
    if (a.t != b.t) return a.t < b.t;
    if (a.node != b.node) return a.node < b.node;
    return a.primitive < b.primitive;
}

}  // namespace luch
