#pragma once

#include "framework/accel/mesh_bvh.h"

#include <memory>
#include <optional>

namespace luch {

class EmbreeTree;

/// In place of MeshBvh: Embree, in its robust mode, looks for triangles, and intersect_triangle()
/// says where they are hit. Where the two disagree, and for rays that Embree takes badly or not at
/// all, a MeshBvh is searched. So a hit is the same to the bit, but for rays within rounding of a
/// rim, or of two triangles at one distance. Throws Error where this build has no Embree.
class EmbreeMesh {
 public:
    /// Keeps a reference to the mesh.
    EmbreeMesh(const Mesh& mesh, Isa isa);
    EmbreeMesh(EmbreeMesh&&) noexcept;
    ~EmbreeMesh();

    // As of MeshBvh.
    bool closest(const ObjectRay& ray, NodeId node, Hit& best, WorkCounts& work) const;
    [[nodiscard]] bool occluded(const ObjectRay& ray, WorkCounts& work) const;
    void closest(const RayPacket& rays, const Node& seen_as, NodeId node, HitPacket& hits,
                 WorkCounts& work) const;
    void occluded(const RayPacket& rays, const Node& seen_as, float* limits,
                  WorkCounts& work) const;
    void find_crossings(const ObjectRay& ray, Crossings& crossings, WorkCounts& work) const {
        own_.find_crossings(ray, crossings, work);
    }
    [[nodiscard]] std::uint64_t bytes() const;

 private:
    bool settle(std::uint32_t triangle, const ObjectRay& ray, NodeId node, Hit& best,
                WorkCounts& work) const;

    const Mesh* mesh_;
    MeshBvh own_;
    std::unique_ptr<EmbreeTree> tree_;  ///< none for a mesh that Embree would not take whole
};

}  // namespace luch
