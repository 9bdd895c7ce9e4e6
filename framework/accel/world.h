#pragma once

#include "framework/accel/accelerator.h"
#include "framework/accel/wide/kernels.h"

namespace luch {

/// Which nodes of a scene a ray may meet: a tree over their boxes in float, relative to the scene's
/// middle. Boxes are rounded outwards and counted as met within the rounding of all that comes
/// after, so a node is never lost. Keeps a reference to the scene.
class World {
 public:
    /// `skip`: where there is but one node, it is not searched for.
    World(const Scene& scene, Isa isa, bool skip);

    /// Calls visit(node) for the nodes that a ray may meet before `limit`, near to far as far as
    /// their boxes tell; it returns the limit from then on, −∞ to end it.
    template <class Visit>
    void visit(const Ray& ray, float limit, Visit&& visit, WorkCounts& work) const {
        if (single_) {  // its own tree says no as quickly as its box
            visit(bounded_[0]);
            return;
        }
        const auto call = [](void* with, std::uint32_t node) {
            return (*static_cast<std::remove_reference_t<Visit>*>(with))(node);
        };
        walk(ray, limit, call, &visit, work);
    }

    /// The same for a packet; limits: of its rays, which visit(node) lowers itself. False when the
    /// packet meets so many nodes that its rays, few of which meet each, cost less one by one: then
    /// nodes are left.
    template <class Visit>
    bool visit(const RayPacket& rays, const float* limits, Visit&& visit, WorkCounts& work) const {
        if (single_ && all_finite(rays.origin)) {
            visit(bounded_[0]);
            return true;
        }
        const auto call = [](void* with, std::uint32_t node) {
            (*static_cast<std::remove_reference_t<Visit>*>(with))(node);
        };
        return walk(rays, limits, call, &visit, work);
    }

    [[nodiscard]] std::uint64_t bytes() const;

 private:
    void walk(const Ray& ray, float limit, float (*each)(void*, std::uint32_t), void* with,
              WorkCounts& work) const;
    bool walk(const RayPacket& rays, const float* limits, void (*each)(void*, std::uint32_t),
              void* with, WorkCounts& work) const;

    /// See the kernels' walk(); `origin` relative to the middle.
    [[nodiscard]] float slack_for(const Vec3d& origin) const;

    std::vector<NodeId> unbounded_, bounded_;
    Vec3d centre_{0};
    bool single_ = false;        ///< there is one node, bounded, and it needs no search
    wide::Tree tree_;            ///< over the boxes of bounded_
    float slack_from_afar_ = 0;  ///< more slack, for rays that start far outside
    const wide::Kernels* kernels_;
};

}  // namespace luch
