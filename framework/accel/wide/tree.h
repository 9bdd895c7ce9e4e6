#pragma once

#include "framework/math/bounds.h"

#include <cstdint>
#include <vector>

// The tree that rays walk: eight boxes a node, four triangles a leaf, both one structure of arrays.
namespace luch::wide {

/// A child is a node's index, or with leaf_bit the index of a block of triangles, or what else a
/// leaf stands for.
inline constexpr std::uint32_t leaf_bit = 0x80000000u;
inline constexpr int node_width = 8;
inline constexpr int block_width = 4;
/// No path from the root is longer (Bvh::stack_size is the binary tree's limit).
inline constexpr int max_depth = 88;

struct alignas(64) Node {
    float bounds[6][node_width];      ///< lo.x, hi.x, lo.y, hi.y, lo.z, hi.z
    std::uint32_t child[node_width];  ///< used ones first
    std::uint32_t used;               ///< a bit for each child

    [[nodiscard]] Box box(int slot) const {
        return {{bounds[0][slot], bounds[2][slot], bounds[4][slot]},
                {bounds[1][slot], bounds[3][slot], bounds[5][slot]}};
    }
};

/// The corners are those of the mesh to the bit. A block that is not full repeats its last
/// triangle.
struct alignas(64) Block {
    float corner[9][block_width];  ///< p0.x, p0.y, p0.z, p1.x, …
    float edge[block_width];       ///< the largest |component| of a triangle's edges
    std::uint32_t id[block_width];

    [[nodiscard]] Vec3 point(int which, int lane) const {
        return {corner[3 * which][lane], corner[3 * which + 1][lane], corner[3 * which + 2][lane]};
    }
    /// How many triangles it holds, without the repeated one.
    [[nodiscard]] int count() const {
        int n = 1;
        while (n < block_width && id[n] != id[n - 1]) ++n;
        return n;
    }
};

/// Root: node 0, which always exists. Trees over boxes have no blocks.
struct Tree {
    std::vector<Node> nodes;
    std::vector<Block> blocks;
    bool cull_backfaces = false;
    float extent = 0;  ///< no bound of a node is larger

    /// Asks the memory for what a child stands for, which will be read soon.
    void prefetch(std::uint32_t child) const {
        const bool leaf = (child & leaf_bit) != 0;
        const char* at = leaf ? reinterpret_cast<const char*>(&blocks[child & ~leaf_bit])
                              : reinterpret_cast<const char*>(&nodes[child]);
        for (int line = 0; line < 3; ++line) __builtin_prefetch(at + 64 * line);
        if (!leaf) __builtin_prefetch(at + 192);
    }

    [[nodiscard]] std::uint64_t bytes() const {
        return nodes.size() * sizeof(Node) + blocks.size() * sizeof(Block);
    }
};

}  // namespace luch::wide
