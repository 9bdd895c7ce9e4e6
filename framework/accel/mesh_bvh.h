#pragma once

#include "framework/accel/accelerator.h"
#include "framework/accel/crossings.h"
#include "framework/accel/wide/kernels.h"
#include "framework/scene/scene.h"

namespace luch {

/// A BVH over the triangles of one mesh.
class MeshBvh {
 public:
    MeshBvh(const Mesh& mesh, Isa isa);

    /// Improves `best` (by nearer()) with the triangles of this mesh, seen as `node`; true when it
    /// did. `ray` is in the mesh's frame.
    bool closest(const ObjectRay& ray, NodeId node, Hit& best, WorkCounts& work) const {
        return kernels_->closest(tree_, ray, node, best, work);
    }
    [[nodiscard]] bool occluded(const ObjectRay& ray, WorkCounts& work) const {
        return kernels_->occluded(tree_, ray, work);
    }
    /// The same for packets in world space; see wide::Kernels for what hits and limits hold.
    void closest(const RayPacket& rays, const Node& seen_as, NodeId node, HitPacket& hits,
                 WorkCounts& work) const {
        kernels_->closest_packet(tree_, seen_as.to_object, rays, node, hits, work);
    }
    void occluded(const RayPacket& rays, const Node& seen_as, float* limits,
                  WorkCounts& work) const {
        kernels_->occluded_packet(tree_, seen_as.to_object, rays, limits, work);
    }

    /// Adds all places where the ray passes through the mesh's surface, backfaces and all.
    void find_crossings(const ObjectRay& ray, Crossings& crossings, WorkCounts& work) const;

    [[nodiscard]] std::uint64_t bytes() const { return tree_.bytes(); }

 private:
    wide::Tree tree_;
    const wide::Kernels* kernels_;
};

/// Improves `best` with one triangle. The only place where a triangle's hit becomes a Hit.
bool improve(const ObjectRay& ray, const Vec3& p0, const Vec3& p1, const Vec3& p2,
             bool cull_backfaces, NodeId node, std::uint32_t triangle, Hit& best);

}  // namespace luch
