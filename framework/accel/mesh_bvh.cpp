#include "framework/accel/mesh_bvh.h"

#include "framework/accel/wide/build.h"

namespace luch {
MeshBvh::MeshBvh(const Mesh& mesh, Isa isa)
    : tree_(wide::built(mesh, isa)), kernels_(&wide::kernels(isa)) {}

void MeshBvh::find_crossings(const ObjectRay& ray, Crossings& crossings, WorkCounts& work) const {
    std::array<std::uint32_t, wide::max_depth * wide::node_width> stack;
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const std::uint32_t child = stack[--size];
        if ((child & wide::leaf_bit) != 0) {
            const wide::Block& block = tree_.blocks[child & ~wide::leaf_bit];
            for (int k = 0; k < block.count(); ++k) {
                TriangleHit hit;
                const bool crosses = cross_triangle(ray, block.point(0, k), block.point(1, k),
                                                    block.point(2, k), hit);
                ++work.primitives;
                if (crosses) crossings.add(hit, block.id[k]);
            }
            continue;
        }
        const wide::Node& node = tree_.nodes[child];
        for (int slot = 0; (node.used >> slot & 1) != 0; ++slot) {
            ++work.boxes;
            const Interval in = slab(node.box(slot), ray);
            if (in.near <= in.far && in.far > ray.t_min) stack[size++] = node.child[slot];
        }
    }
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
