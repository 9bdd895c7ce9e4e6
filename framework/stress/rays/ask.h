#pragma once

#include "framework/accel/accelerator.h"
#include "framework/math/rng.h"
#include "framework/stress/rays/rows.h"

#include <fmt/format.h>

namespace luch::stress {

/// For the report of a failure.
inline std::string words_of(const Ray& ray) {
    const Vec3d &o = ray.origin, &d = ray.direction;
    return fmt::format("from ({}, {}, {}) to ({}, {}, {}) within {} and {}", o.x, o.y, o.z, d.x,
                       d.y, d.z, ray.t_min, ray.t_max);
}

/// Asks for the rays of a packet in all four ways: closest and occluded, alone and in the packet.
/// They must agree, and right(i, hit) must hold.
template <class Right>
void ask(const Accelerator& accelerator, const RayPacket& rays, Tally& tally, Right&& right) {
    WorkCounts work;
    HitPacket hits;
    std::array<std::uint8_t, RayPacket::capacity> blocked;
    accelerator.closest(rays, hits, work);
    accelerator.occluded(rays, blocked, work);
    for (int i = 0; i < rays.count; ++i) {
        const Ray ray = rays.ray(i);
        const Hit alone = accelerator.closest(ray, work);
        const bool any = static_cast<bool>(alone);
        const bool agree = hits.hit(i) == alone && (blocked[i] != 0) == any &&
                           accelerator.occluded(ray, work) == any;
        tally.judge(agree && right(i, alone), [&] {
            return fmt::format("{}: t {} triangle {}, {}", words_of(ray), alone.t, alone.primitive,
                               agree ? "wrong" : "packets and rays alone differ");
        });
    }
}

/// Calls one(key, count) for packets of `total` rays in all.
template <class One>
void each_packet(std::uint64_t total, Key key, One&& one) {
    for (std::uint64_t i = 0; i * RayPacket::capacity < total; ++i) {
        const std::uint64_t rest = total - i * RayPacket::capacity;
        one(key.branch(i), static_cast<int>(std::min<std::uint64_t>(rest, RayPacket::capacity)));
    }
}

}  // namespace luch::stress
