#include "framework/raster/soup.h"

#include <algorithm>
#include <utility>

namespace luch::raster {
namespace {

/// Every third bit of the result is one of x.
std::uint64_t spread(std::uint64_t x) {
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

/// Where a point lies on the Morton curve through a box; any number for points that are not finite.
std::uint64_t along_curve(const Vec3d& point, const Boxd& box) {
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double share = (point[axis] - box.lo[axis]) / (box.hi[axis] - box.lo[axis]);
        const double cell = share > 0 ? std::min(share, 1.0) * 0x1fffff : 0;
        code |= spread(static_cast<std::uint64_t>(cell)) << axis;
    }
    return code;
}

bool can_be_hit(const Triangle& triangle) {
    for (const float x : triangle.corner) {
        if (std::isnan(x)) return false;
    }
    return triangle.edge > 0;
}

Triangle triangle_of(const Mesh& mesh, std::uint32_t id) {
    Triangle triangle{};
    triangle.id = id;
    for (int k = 0; k < 3; ++k) {
        const Vec3& p = mesh.corner(id, k);
        const Vec3 edge = mesh.corner(id, (k + 1) % 3) - p;
        triangle.edge = std::max(triangle.edge, max_norm(edge));
        for (int axis = 0; axis < 3; ++axis) triangle.corner[3 * k + axis] = p[axis];
    }
    return triangle;
}

std::vector<Triangle> sorted_triangles(const Mesh& mesh) {
    std::vector<Triangle> triangles;
    Boxd centres;
    const auto centre = [](const Triangle& t) {
        return Vec3d(t.point(0)) + Vec3d(t.point(1)) + Vec3d(t.point(2));
    };
    for (std::uint32_t id = 0; id < mesh.triangles.size(); ++id) {
        const Triangle triangle = triangle_of(mesh, id);
        if (!can_be_hit(triangle)) continue;
        triangles.push_back(triangle);
        if (all_finite(centre(triangle))) centres.grow(centre(triangle));
    }
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        order.emplace_back(along_curve(centre(triangles[i]), centres), i);
    }
    std::sort(order.begin(), order.end());
    std::vector<Triangle> sorted;
    sorted.reserve(order.size());
    for (const auto& [code, i] : order) sorted.push_back(triangles[i]);
    return sorted;
}

Block block_of(const std::vector<Triangle>& triangles, std::uint32_t first) {
    Block block{};
    const auto left = static_cast<std::uint32_t>(triangles.size() - first);
    block.first = first;
    block.count = std::min<std::uint32_t>(block_width, left);
    for (std::uint32_t lane = 0; lane < block_width; ++lane) {
        const Triangle& triangle = triangles[first + std::min(lane, block.count - 1)];
        for (int i = 0; i < 9; ++i) block.corner[i][lane] = triangle.corner[i];
        block.edge[lane] = triangle.edge;
    }
    return block;
}

}  // namespace

Soup soup_of(const Mesh& mesh) {
    Soup soup;
    soup.cull_backfaces = mesh.cull_backfaces;
    soup.triangles = sorted_triangles(mesh);
    for (std::uint32_t i = 0; i < soup.triangles.size(); i += block_width) {
        soup.blocks.push_back(block_of(soup.triangles, i));
        if (i % chunk_width == 0) {
            soup.chunks.push_back({static_cast<std::uint32_t>(soup.blocks.size() - 1), 0, {}});
        }
        Chunk& chunk = soup.chunks.back();
        ++chunk.count;
        for (std::uint32_t k = i; k < i + soup.blocks.back().count; ++k) {
            for (int corner = 0; corner < 3; ++corner) {
                chunk.box.grow(soup.triangles[k].point(corner));
            }
        }
        soup.box.grow(chunk.box);
    }
    return soup;
}

}  // namespace luch::raster
