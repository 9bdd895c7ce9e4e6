#pragma once

#include "framework/accel/packet.h"
#include "framework/accel/wide/lanes.h"
#include "framework/accel/wide/tree.h"
#include "framework/math/transform.h"

#include <bit>

// A packet in a mesh's frame, with what bounds its sixteen groups of sixteen rays. Only kernel
// files include this; nothing here has linkage.
namespace luch::wide {
namespace {

using Sixteen = Lanes<16>;
inline constexpr int groups = 16;

/// Ranges of one number, for each group and for all.
struct Ranges {
    alignas(64) float lo[groups];
    alignas(64) float hi[groups];
    float lo_all, hi_all;

    [[nodiscard]] float width() const { return hi_all - lo_all; }
    [[nodiscard]] float width(int group) const { return hi[group] - lo[group]; }
    void close() {
        lo_all = -largest_lane(Sixteen(0.0f) - Sixteen::load(lo));
        hi_all = largest_lane(Sixteen::load(hi));
    }
};

/// The rays' data, sixteen of a group together. Lanes without a ray repeat another's direction and
/// have t = −∞, so that nothing improves them.
struct Bundle {
    Vec3 origin;
    float t_min;
    alignas(64) float direction[3][RayPacket::capacity];
    alignas(64) float inverse[3][RayPacket::capacity];
    /// The limit of every ray, −∞ when it looks for nothing any more.
    alignas(64) float t[RayPacket::capacity];

    Ranges inverses[3];  ///< (−∞, ∞) where the signs differ or an inverse is not finite
    alignas(64) float sign[3][groups];   ///< of the directions, ±1; anything where they differ
    unsigned negative_lanes[3][groups];  ///< a bit for each ray whose direction has the sign bit
    bool negative[3];                    ///< the sign of all groups
    bool coherent;                       ///< all signs are the same, all inverses finite
    alignas(64) float limit[groups];     ///< the largest t of a group
    float limit_all;

    /// All directions are multiples of (u, v, 1), by cyclic order after the axis `main`; main < 0:
    /// their signs differ in every axis.
    int main;
    Ranges u, v;
    /// Groups that point in as many directions as the whole bundle, or nearly: what lies between
    /// their rays is large, so their rays are tested against boxes one by one.
    unsigned wide;
    float cone_sum;       ///< no |u| + |v| + 1 exceeds it
    float direction_sum;  ///< no |x| + |y| + |z| of a direction exceeds it

    [[nodiscard]] ObjectRay ray(int lane, float t_max) const {
        return {origin,
                {direction[0][lane], direction[1][lane], direction[2][lane]},
                {inverse[0][lane], inverse[1][lane], inverse[2][lane]},
                t_min,
                t_max};
    }
    void update_limit(int group) { limit[group] = largest_lane(Sixteen::load(t + group * groups)); }
    void update_limits() { limit_all = largest_lane(Sixteen::load(limit)); }
};

LUCH_INLINE void reduce(const float* values, Ranges& ranges) {
    for (int g = 0; g < groups; ++g) {
        const Sixteen at = Sixteen::load(values + g * groups);
        ranges.hi[g] = largest_lane(at);
        ranges.lo[g] = -largest_lane(Sixteen(0.0f) - at);
    }
    ranges.close();
}

/// The same operations as Transform::direction and object_ray().
LUCH_INLINE void turn(const RayPacket& rays, const Transform& to_object, Bundle& bundle) {
    for (int axis = 0; axis < 3; ++axis) {
        const double mx = to_object.matrix[axis][0], my = to_object.matrix[axis][1],
                     mz = to_object.matrix[axis][2];
        float* to = bundle.direction[axis];
        for (int i = 0; i < rays.count; ++i) {
            to[i] = static_cast<float>(rays.x[i] * mx + rays.y[i] * my + rays.z[i] * mz);
        }
        for (int i = 0; i < rays.count; i += groups) drop_denormals(to + i);
    }
}

/// A bit for each lane of a group that looks for something.
LUCH_INLINE unsigned active_lanes(const Bundle& bundle, int group) {
    return Sixteen(bundle.t_min) <= Sixteen::load(bundle.t + group * groups);
}

/// Lanes that look for nothing take the direction of one that does; false when none does.
inline bool fill_idle_lanes(Bundle& bundle) {
    unsigned active[groups];
    int first = -1;
    for (int g = groups; g-- > 0;) {
        active[g] = active_lanes(bundle, g);
        if (active[g] != 0) first = g * groups + std::countr_zero(active[g]);
    }
    if (first < 0) return false;
    for (int g = 0; g < groups; ++g) {
        if (active[g] == 0xffff) continue;
        const auto keep = [&](float* lanes, float other) {
            Sixteen::select(active[g], Sixteen::load(lanes + g * groups), other)
                .store(lanes + g * groups);
        };
        for (auto& axis : bundle.direction) keep(axis, axis[first]);
        keep(bundle.t, -infinite);
    }
    return true;
}

/// A bit for each lane of a group whose direction neither overflows nor vanishes in products, so
/// that the bundle's bounds hold for it. NaN is not tame.
LUCH_INLINE unsigned tame_lanes(const Bundle& bundle, int group) {
    unsigned small = 0xffff, some = 0;
    for (const auto& axis : bundle.direction) {
        const Sixteen size = abs(Sixteen::load(axis + group * groups));
        small &= size < Sixteen(0x1p60f);
        some |= Sixteen(0x1p-60f) < size;
    }
    return small & some;
}

inline void bound_axis(Bundle& bundle, int axis, Ranges& direction) {
    reduce(bundle.direction[axis], direction);
    Ranges& inverses = bundle.inverses[axis];
    bool finite = true;
    for (int g = 0; g < groups; ++g) {
        const float lo = 1 / direction.hi[g], hi = 1 / direction.lo[g];
        const bool one_sign = direction.lo[g] > 0 || direction.hi[g] < 0;
        const bool bounded = one_sign && std::abs(lo) < infinite && std::abs(hi) < infinite;
        inverses.lo[g] = bounded ? lo : -infinite;
        inverses.hi[g] = bounded ? hi : infinite;
        bundle.sign[axis][g] = direction.hi[g] < 0 ? -1.0f : 1.0f;
        finite &= bounded;
    }
    inverses.close();
    bundle.negative[axis] = direction.hi_all < 0;
    const bool one_sign = direction.lo_all > 0 || direction.hi_all < 0;
    if (!one_sign) {
        inverses.lo_all = -infinite;
        inverses.hi_all = infinite;
    }
    bundle.coherent &= finite && one_sign;
}

/// The cone of the groups around the axis that no direction is near perpendicular to.
inline void bound_cone(Bundle& bundle, const Ranges (&directions)[3]) {
    bundle.main = -1;
    bundle.wide = 0xffff;
    float strongest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float strength = std::max(directions[axis].lo_all, -directions[axis].hi_all);
        if (strength > strongest) {
            strongest = strength;
            bundle.main = axis;
        }
    }
    if (bundle.main < 0) return;
    alignas(64) float share[RayPacket::capacity];
    const float* whole = bundle.direction[bundle.main];
    for (int k = 1; k < 3; ++k) {
        const float* part = bundle.direction[(bundle.main + k) % 3];
        for (int i = 0; i < RayPacket::capacity; i += groups) {
            (Sixteen::load(part + i) / Sixteen::load(whole + i)).store(share + i);
        }
        reduce(share, k == 1 ? bundle.u : bundle.v);
    }
    const float width = bundle.u.width() + bundle.v.width();
    for (int g = 0; g < groups; ++g) {
        const bool narrow = bundle.u.width(g) + bundle.v.width(g) < 0.5f * width;
        if (narrow) bundle.wide &= ~(1u << g);
    }
    const auto size = [](const Ranges& r) {
        return std::max(std::abs(r.lo_all), std::abs(r.hi_all));
    };
    bundle.cone_sum = (size(bundle.u) + size(bundle.v) + 1) * (1 + 0x1p-20f);
    if (!(bundle.cone_sum < 1e6f)) bundle.main = -1;
}

/// Turns a packet into the mesh's frame. Lanes beyond its count look for nothing.
inline void fill(Bundle& bundle, const RayPacket& rays, const Transform& to_object,
                 const float* limits) {
    bundle.origin = Vec3(to_object.point(rays.origin));
    for (int axis = 0; axis < 3; ++axis) bundle.origin[axis] = normal_or_zero(bundle.origin[axis]);
    bundle.t_min = least_t(rays.t_min);
    turn(rays, to_object, bundle);
    std::copy(limits, limits + rays.count, bundle.t);
    std::fill(bundle.t + rays.count, bundle.t + RayPacket::capacity, -infinite);
}

/// Bounds the filled bundle; false when no ray looks for anything.
inline bool bound(Bundle& bundle) {
    if (!fill_idle_lanes(bundle)) return false;
    for (int axis = 0; axis < 3; ++axis) {
        for (int g = 0; g < groups; ++g) {
            const Sixteen inverse =
                Sixteen(1.0f) / Sixteen::load(bundle.direction[axis] + g * groups);
            inverse.store(bundle.inverse[axis] + g * groups);
            bundle.negative_lanes[axis][g] = inverse < Sixteen(0.0f);
        }
    }
    bundle.coherent = true;
    bundle.direction_sum = 0;
    Ranges directions[3];
    for (int axis = 0; axis < 3; ++axis) {
        bound_axis(bundle, axis, directions[axis]);
        bundle.direction_sum +=
            std::max(std::abs(directions[axis].lo_all), std::abs(directions[axis].hi_all));
    }
    bound_cone(bundle, directions);
    for (int g = 0; g < groups; ++g) bundle.update_limit(g);
    bundle.update_limits();
    return true;
}

}  // namespace
}  // namespace luch::wide
