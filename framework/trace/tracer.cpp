#include "framework/trace/tracer.h"

#include <cassert>

namespace luch {

void Tracer::closest(RayKind kind, std::span<const Ray> rays, std::span<Hit> hits) {
    assert(rays.size() == hits.size());
    counts_.of(kind) += rays.size();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i] = accelerator_->closest(rays[i], counts_.work);
    }
    if (log_ != nullptr) log_->closest(kind, rays, hits);
}

Hit Tracer::closest(RayKind kind, const Ray& ray) {
    Hit hit;
    closest(kind, {&ray, 1}, {&hit, 1});
    return hit;
}

void Tracer::occluded(RayKind kind, std::span<const Ray> rays, std::span<std::uint8_t> blocked) {
    assert(rays.size() == blocked.size());
    counts_.of(kind) += rays.size();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        blocked[i] = accelerator_->occluded(rays[i], counts_.work) ? 1 : 0;
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
