#include "framework/accel/wide/kernels.h"
#include "framework/accel/wide/packet_search.h"
#include "framework/accel/wide/shape_packet.h"
#include "framework/accel/wide/split_kernel.h"

#include <cstring>

// Compiled once for every level, see luch_kernels(). The entry is all that may be seen from
// outside: an inline function of a library that were compiled here and kept by the linker would
// crash older machines (tests/accel looks with nm).
namespace luch::wide {
namespace {

/// Rays whose directions are too large or small for a bundle's bounds go alone.
template <class Alone>
void search_untamed(const RayPacket& rays, const Transform& to_object, Bundle& bundle,
                    Alone&& alone) {
    for (int group = 0; group * groups < rays.count; ++group) {
        for (unsigned rest = ~tame_lanes(bundle, group) & 0xffff; rest != 0; rest &= rest - 1) {
            const int i = group * groups + std::countr_zero(rest);
            if (i >= rays.count || bundle.t[i] == -infinite) continue;
            const Ray ray = rays.ray(i);
            const bool sound = all_finite(ray.direction) && ray.direction != Vec3d(0);
            if (sound) alone(i, object_ray(to_object.ray(ray)));
            bundle.t[i] = -infinite;
        }
    }
}

/// Calls one(i) for every ray that still looks for something.
template <class One>
void each_ray_left(const Bundle& bundle, One&& one) {
    for (int group = 0; group < groups; ++group) {
        for (unsigned rest = active_lanes(bundle, group); rest != 0; rest &= rest - 1) {
            one(group * groups + std::countr_zero(rest));
        }
    }
}

/// barycentric() in lanes.
LUCH_INLINE Sixteen share(const Sixteen& part, const Sixteen& whole, const Sixteen& limit) {
    const Sixteen ratio = part / whole;
    return Sixteen::select(Sixteen(0.0f) < ratio, min_or(limit, ratio), 0.0f);
}

void write_group(const Bundle& bundle, const Found& found, int group, NodeId node,
                 HitPacket& hits) {
    const int at = group * groups;
    const unsigned improved = found.improved[group];
    const auto weight = [&](int k) { return Sixteen::load(found.weight[k] + at); };
    const Sixteen whole = weight(0) + weight(1) + weight(2);
    const Sixteen u = share(weight(1), whole, 1.0f);
    const Sixteen v = share(weight(2), whole, Sixteen(1.0f) - u);
    const auto put = [&](float* to, const Sixteen& value) {
        Sixteen::select(improved, value, Sixteen::load(to + at)).store(to + at);
    };
    put(hits.t, Sixteen::load(bundle.t + at));
    put(hits.u, u);
    put(hits.v, v);
    std::uint32_t primitive[groups];
    std::memcpy(primitive, found.primitive + at, sizeof primitive);
    for (int i = 0; i < groups; ++i) {
        const bool set = (improved >> i & 1) != 0;
        hits.node[at + i] = set ? node : hits.node[at + i];
        hits.primitive[at + i] = set ? primitive[i] : hits.primitive[at + i];
    }
}

void closest_packet(const Tree& tree, const Transform& to_object, const RayPacket& rays,
                    NodeId node, HitPacket& hits, WorkCounts& work) {
    Bundle bundle;
    fill(bundle, rays, to_object, hits.t);
    search_untamed(rays, to_object, bundle, [&](int i, const ObjectRay& ray) {
        Hit best = hits.hit(i);
        closest(tree, ray, node, best, work);
        hits.set(i, best);
    });
    if (!bound(bundle)) return;
    Found found;
    const bool finished = PacketSearch<false>(tree, node, &hits, bundle, found).run(work);
    for (int group = 0; group < groups; ++group) {
        if (found.improved[group] != 0) write_group(bundle, found, group, node, hits);
    }
    if (finished) return;
    each_ray_left(bundle, [&](int i) {
        Hit best = hits.hit(i);
        if (closest(tree, bundle.ray(i, rays.t_max[i]), node, best, work)) hits.set(i, best);
    });
}

void occluded_packet(const Tree& tree, const Transform& to_object, const RayPacket& rays,
                     float* limits, WorkCounts& work) {
    Bundle bundle;
    fill(bundle, rays, to_object, limits);
    search_untamed(rays, to_object, bundle, [&](int i, const ObjectRay& ray) {
        if (occluded(tree, ray, work)) limits[i] = -infinite;
    });
    if (!bound(bundle)) return;
    Found found;
    const bool finished = PacketSearch<true>(tree, 0, nullptr, bundle, found).run(work);
    if (!finished) {
        each_ray_left(bundle, [&](int i) {
            if (!occluded(tree, bundle.ray(i, rays.t_max[i]), work)) return;
            found.improved[i / groups] |= 1u << (i % groups);
        });
    }
    for (int group = 0; group < groups; ++group) {
        for (unsigned rest = found.improved[group]; rest != 0; rest &= rest - 1) {
            limits[group * groups + std::countr_zero(rest)] = -infinite;
        }
    }
}

}  // namespace

#define LUCH_NAME_OF(level) kernels_##level
#define LUCH_NAME(level) LUCH_NAME_OF(level)

const Kernels& LUCH_NAME(LUCH_LEVEL)() {
    static constexpr Kernels all{closest,         occluded,   walk,        closest_packet,
                                 occluded_packet, meet_plane, meet_sphere, meet_cube,
                                 range_of,        split_range};
    return all;
}

}  // namespace luch::wide
