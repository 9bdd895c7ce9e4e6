#include "framework/accel/mesh_bvh.h"

namespace luch {
namespace {

Bvh<Box> bvh_of(const Mesh& mesh) {
    std::vector<Box> boxes(mesh.triangles.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) boxes[i] = mesh.box(i);
    return Bvh<Box>(boxes);
}

/// For Bvh::walk.
auto enter_node(const Bvh<Box>& bvh, const ObjectRay& ray, WorkCounts& work) {
    return [&](std::uint32_t index) {
        ++work.boxes;
        const Interval in = slab(bvh.nodes()[index].box, ray);
        return in.near <= in.far && in.far > ray.t_min ? in.near
                                                       : std::numeric_limits<float>::quiet_NaN();
    };
}

}  // namespace

MeshBvh::MeshBvh(const Mesh& mesh) : bvh_(bvh_of(mesh)), cull_backfaces_(mesh.cull_backfaces) {
    triangles_.reserve(mesh.triangles.size());
    for (const std::uint32_t i : bvh_.order()) {
        triangles_.push_back({mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2), i});
    }
}

void MeshBvh::closest(const ObjectRay& ray, NodeId node, bool any, Hit& best,
                      WorkCounts& work) const {
    const auto leaf = [&](const Bvh<Box>::Node& at) {
        work.primitives += at.count;
        bool found = false;
        for (std::uint32_t i = at.first; i < at.first + at.count; ++i) {
            const Triangle& triangle = triangles_[i];
            found |= improve(ray, triangle.p0, triangle.p1, triangle.p2, cull_backfaces_, node,
                             triangle.id, best);
        }
        return any && found;
    };
    bvh_.walk(
        enter_node(bvh_, ray, work), [&] { return best.t; }, leaf);
}

void MeshBvh::find_crossings(const ObjectRay& ray, Crossings& crossings, WorkCounts& work) const {
    const auto leaf = [&](const Bvh<Box>::Node& at) {
        work.primitives += at.count;
        for (std::uint32_t i = at.first; i < at.first + at.count; ++i) {
            const Triangle& triangle = triangles_[i];
            TriangleHit hit;
            if (cross_triangle(ray, triangle.p0, triangle.p1, triangle.p2, hit)) {
                crossings.add(hit, triangle.id);
            }
        }
        return false;
    };
    bvh_.walk(
        enter_node(bvh_, ray, work), [] { return std::numeric_limits<float>::infinity(); }, leaf);
}

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
