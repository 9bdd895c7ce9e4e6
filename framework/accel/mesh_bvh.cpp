#include "framework/accel/mesh_bvh.h"

#include "framework/accel/wide/collapse.h"

namespace luch {
namespace {

Bvh<Box> bvh_of(const Mesh& mesh) {
    std::vector<Box> boxes(mesh.triangles.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) boxes[i] = mesh.box(i);
    return Bvh<Box>(boxes);
}

}  // namespace

MeshBvh::MeshBvh(const Mesh& mesh, Isa isa)
    : tree_(wide::collapsed(bvh_of(mesh), mesh)), kernels_(&wide::kernels(isa)) {}

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
