#pragma once

#include "framework/scene/geometry.h"

#include <cstdint>
#include <vector>

// A mesh as the rasteriser wants it: sixteen triangles side by side, neighbours together.
namespace luch::raster {

inline constexpr int block_width = 16;
inline constexpr int blocks_of_chunk = 16;
inline constexpr int chunk_width = block_width * blocks_of_chunk;

/// The corners are those of the mesh to the bit. Lanes from `count` on repeat the last triangle.
struct alignas(64) Block {
    float corner[9][block_width];  ///< p0.x, p0.y, p0.z, p1.x, …
    float edge[block_width];       ///< the largest |component| of a triangle's edges
    std::uint32_t first, count;    ///< in Soup::triangles
};

/// One triangle by itself, for the resolve.
struct alignas(16) Triangle {
    float corner[9];
    float edge;
    std::uint32_t id;  ///< in the mesh

    [[nodiscard]] Vec3 point(int which) const {
        return {corner[3 * which], corner[3 * which + 1], corner[3 * which + 2]};
    }
};

/// Consecutive blocks and the box of their triangles.
struct Chunk {
    std::uint32_t first, count;
    Box box;
};

/// All triangles that a ray can hit: those with a NaN in them, or whose corners are all one point,
/// have no normal and are left out.
struct Soup {
    std::vector<Block> blocks;
    std::vector<Triangle> triangles;
    std::vector<Chunk> chunks;
    Box box;
    bool cull_backfaces = false;

    [[nodiscard]] std::uint64_t bytes() const {
        return blocks.size() * sizeof(Block) + triangles.size() * sizeof(Triangle) +
               chunks.size() * sizeof(Chunk);
    }
};

Soup soup_of(const Mesh& mesh);

}  // namespace luch::raster
