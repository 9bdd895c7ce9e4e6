#include "framework/accel/mesh_bvh.h"

#include "framework/accel/wide/build.h"

namespace luch {
MeshBvh::MeshBvh(const Mesh& mesh, Isa isa)
    : tree_(wide::built(mesh, isa)), kernels_(&wide::kernels(isa)) {}

bool improve(const ObjectRay& ray, const Vec3& p0, const Vec3& p1, const Vec3& p2,
             bool cull_backfaces, NodeId node, std::uint32_t triangle, Hit& best) {
    TriangleHit found;
    if (!intersect_triangle(ray, p0, p1, p2, cull_backfaces, found)) return false;
    const Hit hit{found.t, found.u, found.v, node, triangle};
    if (!nearer(hit, best)) return false;
    best = hit;
    return true;
}

}  // namespace luch
