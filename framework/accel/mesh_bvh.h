#pragma once

#include "framework/accel/accelerator.h"
#include "framework/accel/bvh.h"
#include "framework/accel/crossings.h"
#include "framework/accel/hit.h"
#include "framework/scene/geometry.h"

namespace luch {

/// A BVH over the triangles of one mesh, with their corners stored in the order of its leaves.
class MeshBvh {
 public:
    explicit MeshBvh(const Mesh& mesh);

    /// Improves `best` (by nearer()) with the triangles of this mesh, seen as `node`. `ray` is in
    /// the mesh's frame. With `any`, the first hit found ends the search.
    void closest(const ObjectRay& ray, NodeId node, bool any, Hit& best, WorkCounts& work) const;

    /// Adds all places where the ray passes through the mesh's surface, backfaces and all.
    void find_crossings(const ObjectRay& ray, Crossings& crossings, WorkCounts& work) const;

    [[nodiscard]] std::uint64_t bytes() const {
        return bvh_.bytes() + triangles_.size() * sizeof(Triangle);
    }

 private:
    struct Triangle {
        Vec3 p0, p1, p2;
        std::uint32_t id;
    };
    Bvh<Box> bvh_;
    std::vector<Triangle> triangles_;
    bool cull_backfaces_;
};

/// Improves `best` with one triangle. The only place where a triangle's hit becomes a Hit.
bool improve(const ObjectRay& ray, const Vec3& p0, const Vec3& p1, const Vec3& p2,
             bool cull_backfaces, NodeId node, std::uint32_t triangle, Hit& best);

}  // namespace luch
