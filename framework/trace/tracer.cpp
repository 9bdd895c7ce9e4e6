#include "framework/trace/tracer.h"

#include <algorithm>
#include <cassert>

namespace luch {
namespace {

/// Fewer rays than this are not worth a packet.
constexpr std::size_t fewest = 32;

/// Whether rays can share packets: one origin and one t_min.
bool go_together(std::span<const Ray> rays) {
    if (rays.size() < fewest) return false;
    for (const Ray& ray : rays) {
        if (ray.origin != rays[0].origin || ray.t_min != rays[0].t_min) return false;
    }
    return true;
}

/// How many of a packet's entries look for something.
std::uint64_t count_of(const RayPacket& rays) {
    return static_cast<std::uint64_t>(std::count_if(
        rays.t_max, rays.t_max + rays.count, [&](float t_max) { return t_max > rays.t_min; }));
}

/// Fills packets with rays that go together, in their order; calls work(first ray, how many).
template <class Work>
void each_packet(std::span<const Ray> rays, RayPacket& packet, Work&& work) {
    packet.origin = rays[0].origin;
    packet.t_min = rays[0].t_min;
    for (std::size_t first = 0; first < rays.size(); first += RayPacket::capacity) {
        const std::size_t count = std::min<std::size_t>(RayPacket::capacity, rays.size() - first);
        packet.count = 0;
        for (const Ray& ray : rays.subspan(first, count)) packet.add(ray.direction, ray.t_max);
        work(first, count);
    }
}

}  // namespace

void Tracer::closest_in_packets(std::span<const Ray> rays, std::span<Hit> hits) {
    RayPacket packet;
    HitPacket found;
    each_packet(rays, packet, [&](std::size_t first, std::size_t count) {
        accelerator_->closest(packet, found, counts_.work);
        for (std::size_t i = 0; i < count; ++i) hits[first + i] = found.hit(static_cast<int>(i));
    });
}

void Tracer::closest(RayKind kind, std::span<const Ray> rays, std::span<Hit> hits) {
    assert(rays.size() == hits.size());
    counts_.of(kind) += rays.size();
    if (go_together(rays)) {
        closest_in_packets(rays, hits);
    } else {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            hits[i] = accelerator_->closest(rays[i], counts_.work);
        }
    }
    if (log_ != nullptr) log_->closest(kind, rays, hits);
}

Hit Tracer::closest(RayKind kind, const Ray& ray) {
    Hit hit;
    closest(kind, {&ray, 1}, {&hit, 1});
    return hit;
}

void Tracer::closest(RayKind kind, const RayPacket& rays, HitPacket& hits) {
    counts_.of(kind) += count_of(rays);
    accelerator_->closest(rays, hits, counts_.work);
    if (log_ == nullptr) return;
    for (int i = 0; i < rays.count; ++i) {
        const Ray ray = rays.ray(i);
        const Hit hit = hits.hit(i);
        if (ray.t_max > ray.t_min) log_->closest(kind, {&ray, 1}, {&hit, 1});
    }
}

void Tracer::occluded(RayKind kind, std::span<const Ray> rays, std::span<std::uint8_t> blocked) {
    assert(rays.size() == blocked.size());
    counts_.of(kind) += rays.size();
    if (go_together(rays)) {
        RayPacket packet;
        each_packet(rays, packet, [&](std::size_t first, std::size_t count) {
            accelerator_->occluded(packet, blocked.subspan(first, count), counts_.work);
        });
    } else {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            blocked[i] = accelerator_->occluded(rays[i], counts_.work) ? 1 : 0;
        }
    }
    if (log_ != nullptr) record_shadows(kind, rays, blocked);
}

bool Tracer::occluded(RayKind kind, const Ray& ray) {
    std::uint8_t blocked = 0;
    occluded(kind, {&ray, 1}, {&blocked, 1});
    return blocked != 0;
}

void Tracer::test(std::span<const NodeId> nodes, std::span<const Ray> rays, std::span<Hit> hits) {
    assert(rays.size() == hits.size() && rays.size() == nodes.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i] = {};
        if (nodes[i] == no_node) continue;
        ++counts_.object_tests;
        hits[i] = accelerator_->closest_in(nodes[i], rays[i], counts_.work);
        if (log_ != nullptr && hits[i]) {
            log_->closest(RayKind::primary, rays.subspan(i, 1), hits.subspan(i, 1));
        }
    }
}

void Tracer::test(NodeId node, const RayPacket& rays, HitPacket& hits) {
    counts_.object_tests += count_of(rays);
    accelerator_->improve(node, rays, hits, counts_.work);
}

void Tracer::record_shadows(RayKind kind, std::span<const Ray> rays,
                            std::span<const std::uint8_t> blocked) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        WorkCounts not_counted;
        Hit blocker;
        if (blocked[i] != 0) blocker = accelerator_->closest(rays[i], not_counted);
        log_->occluded(kind, rays.subspan(i, 1), {&blocker, 1});
    }
}

}  // namespace luch
