#include "framework/accel/wide/collapse.h"

#include <array>

namespace luch::wide {
namespace {

struct Children {
    std::array<std::uint32_t, node_width> node;
    int count = 0;
};

/// The descendants of a binary node that become the children of a wide one.
Children children_of(const Bvh<Box>& bvh, std::uint32_t root) {
    const auto& nodes = bvh.nodes();
    Children children;
    children.node[children.count++] = root;
    while (children.count < node_width) {
        int widest = -1;
        float area = -1;
        for (int i = 0; i < children.count; ++i) {
            const auto& node = nodes[children.node[i]];
            if (node.count > 0 || !(node.box.half_area() > area)) continue;
            area = node.box.half_area();
            widest = i;
        }
        if (widest < 0) break;
        const std::uint32_t first = nodes[children.node[widest]].first;
        children.node[widest] = first;
        children.node[children.count++] = first + 1;
    }
    return children;
}

Block block_of(const Bvh<Box>::Node& leaf, const Bvh<Box>& bvh, const Mesh& mesh) {
    Block block;
    for (int lane = 0; lane < block_width; ++lane) {
        const auto last = static_cast<int>(leaf.count) - 1;
        block.id[lane] = bvh.order()[leaf.first + std::min(lane, last)];
        for (int k = 0; k < 3; ++k) {
            const Vec3& corner = mesh.corner(block.id[lane], k);
            for (int axis = 0; axis < 3; ++axis) block.corner[3 * k + axis][lane] = corner[axis];
        }
    }
    return block;
}

void set_box(Node& node, int slot, const Box& box) {
    for (int axis = 0; axis < 3; ++axis) {
        node.bounds[axis][slot] = box.lo[axis];
        node.bounds[axis + 3][slot] = box.hi[axis];
    }
}

}  // namespace

Tree collapsed(const Bvh<Box>& bvh, const Mesh& mesh) {
    Tree tree;
    tree.cull_backfaces = mesh.cull_backfaces;
    tree.nodes.emplace_back();
    if (bvh.nodes().empty()) {
        for (int i = 0; i < node_width; ++i) set_box(tree.nodes[0], i, Box{});
        return tree;
    }
    struct Task {
        std::uint32_t binary, wide;
    };
    std::vector<Task> tasks{{0, 0}};
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        const Children children = children_of(bvh, task.binary);
        Node node{};
        node.used = (1u << children.count) - 1;
        for (int i = 0; i < node_width; ++i) {
            if (i >= children.count) {
                set_box(node, i, Box{});
                continue;
            }
            const auto& child = bvh.nodes()[children.node[i]];
            set_box(node, i, child.box);
            if (child.count > 0) {
                node.child[i] = leaf_bit | static_cast<std::uint32_t>(tree.blocks.size());
                tree.blocks.push_back(block_of(child, bvh, mesh));
            } else {
                node.child[i] = static_cast<std::uint32_t>(tree.nodes.size());
                tree.nodes.emplace_back();
                tasks.push_back({children.node[i], node.child[i]});
            }
        }
        tree.nodes[task.wide] = node;
    }
    return tree;
}

}  // namespace luch::wide
