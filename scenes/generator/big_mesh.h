#pragma once

#include "framework/math/vec.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

namespace luch::assets {

/// A mesh that is computed point by point and never held, so that it may be of any size.
struct BigMesh {
    std::uint64_t points = 0;
    std::uint64_t triangles = 0;
    std::function<Vec3d(std::uint64_t)> point;
    /// Its corners' points, counter-clockwise from outside in a right-handed world.
    std::function<std::array<std::uint64_t, 3>(std::uint64_t)> triangle;
};

/// A mesh for benchmarks of within 1 % of that many triangles (at least 200), the same on every
/// run: "terrain", hills on a square, easy for a BVH: small triangles of one size, none overlap;
/// "sphere", a closed ball with ripples, thin triangles at its poles;
/// "tangle", long thin triangles through one another in every direction, the worst for a BVH: all
/// boxes overlap. Extents are about 2. Throws Error on another kind or number.
BigMesh big_mesh(std::string_view kind, std::uint64_t triangles);

/// Writes it as .obj or .glb, by the ending, piece by piece. Throws Error{file} on another ending,
/// where it cannot be written, or where a .glb cannot hold that much (4 GB).
void write_big_mesh(const BigMesh& mesh, const std::filesystem::path& file);

}  // namespace luch::assets
