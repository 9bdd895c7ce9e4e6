#pragma once

#include "framework/math/ray.h"

#include <cstdint>

namespace luch {

/// Up to 256 rays that start from one point, in world space: a tile's primary rays, or shadow rays
/// from a light. Fast when neighbours, in groups of sixteen, go the same way; never wrong.
struct RayPacket {
    static constexpr int capacity = 256;
    Vec3d origin{0};
    float t_min = 0;
    int count = 0;  ///< how many of the entries below are rays
    alignas(64) double x[capacity];
    alignas(64) double y[capacity];
    alignas(64) double z[capacity];
    alignas(64) float t_max[capacity];

    /// Appends a direction; there must be room.
    void add(const Vec3d& direction, float t_max_of_it) {
        x[count] = direction.x;
        y[count] = direction.y;
        z[count] = direction.z;
        t_max[count] = t_max_of_it;
        ++count;
    }
    [[nodiscard]] Ray ray(int i) const { return {origin, {x[i], y[i], z[i]}, t_min, t_max[i]}; }
};

/// What the rays of a packet met, in their order; entry i is Hit{t[i], u[i], …}.
struct HitPacket {
    alignas(64) float t[RayPacket::capacity];
    alignas(64) float u[RayPacket::capacity];
    alignas(64) float v[RayPacket::capacity];
    alignas(64) NodeId node[RayPacket::capacity];
    alignas(64) std::uint32_t primitive[RayPacket::capacity];

    [[nodiscard]] Hit hit(int i) const { return {t[i], u[i], v[i], node[i], primitive[i]}; }
    void set(int i, const Hit& hit) {
        t[i] = hit.t;
        u[i] = hit.u;
        v[i] = hit.v;
        node[i] = hit.node;
        primitive[i] = hit.primitive;
    }
};

}  // namespace luch
