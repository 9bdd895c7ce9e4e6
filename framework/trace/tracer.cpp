#include "framework/trace/tracer.h"

#include <cassert>

namespace luch {

void Tracer::closest(RayKind kind, std::span<const Ray> rays, std::span<Hit> hits) {
    assert(rays.size() == hits.size());
    counts_.of(kind) += rays.size();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i] = accelerator_->closest(rays[i], counts_.work);
    }
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
    }
}

}  // namespace luch
