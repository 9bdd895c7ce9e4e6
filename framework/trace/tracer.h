#pragma once

#include "framework/accel/accelerator.h"
#include "framework/trace/counts.h"
#include "framework/trace/ray_log.h"

#include <span>

namespace luch {

/// The only way to shoot a ray, and it counts. One for each worker; not shared between threads.
class Tracer {
 public:
    explicit Tracer(const Accelerator& accelerator) : accelerator_(&accelerator) {}

    /// The nearest hit of every ray. Many rays of one origin go in packets, which are quick when
    /// each sixteen of them are neighbours: blocks of 4 × 4 pixels. The answers are the same.
    void closest(RayKind kind, std::span<const Ray> rays, std::span<Hit> hits);
    [[nodiscard]] Hit closest(RayKind kind, const Ray& ray);
    /// The same for rays that are in a packet already. Those whose t_max does not exceed t_min look
    /// for nothing and are no rays.
    void closest(RayKind kind, const RayPacket& rays, HitPacket& hits);

    /// 1 where anything lies between t_min and t_max, else 0.
    void occluded(RayKind kind, std::span<const Ray> rays, std::span<std::uint8_t> blocked);
    [[nodiscard]] bool occluded(RayKind kind, const Ray& ray);

    /// Rays against one given node each, without a search: object tests, not rays. A ray whose node
    /// is no_node misses and costs nothing.
    void test(std::span<const NodeId> nodes, std::span<const Ray> rays, std::span<Hit> hits);

    /// The rays of a packet against one node: improves `hits`, by nearer(). Not recorded.
    void test(NodeId node, const RayPacket& rays, HitPacket& hits);

    [[nodiscard]] Counts& counts() { return counts_; }

    /// Records every ray from now on; null, as at first: none. An object test that hits is recorded
    /// as the primary ray that it stands for. What is recorded changes neither answers nor counts.
    void record(RayLog* log) { log_ = log; }
    [[nodiscard]] RayLog* log() const { return log_; }

 private:
    void closest_in_packets(std::span<const Ray> rays, std::span<Hit> hits);
    void record_shadows(RayKind kind, std::span<const Ray> rays,
                        std::span<const std::uint8_t> blocked) const;
    const Accelerator* accelerator_;
    Counts counts_;
    RayLog* log_ = nullptr;
};

}  // namespace luch
