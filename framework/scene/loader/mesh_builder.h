#pragma once

#include "framework/math/vec.h"
#include "framework/scene/geometry.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace luch::loader {

/// Indices from 0; −1 where the file gives none.
struct RawCorner {
    std::int64_t position = -1;
    std::int64_t uv = -1;
    std::int64_t normal = -1;
};
using RawTriangle = std::array<RawCorner, 3>;

/// What a mesh's file says, whatever its format; every index is within its array, every number
/// finite.
struct RawMesh {
    std::vector<Vec3d> positions;
    std::vector<Vec3d> normals;  ///< of any length, as written
    std::vector<Vec2d> uvs;
    std::vector<RawTriangle> triangles;
};

struct MeshOptions {
    bool faceted = false;  ///< the triangles' own normals, whatever the file has
    bool auto_smooth =
        false;              ///< where the file has no normals: made from the faces around a vertex
    bool recenter = false;  ///< the mean of all vertices becomes the origin
};

/// The mesh of a file, its triangles in the file's order. A corner without a normal takes its
/// triangle's, one without texture coordinates (0, 0); without any normal (and autoSmooth) the mesh
/// is faceted. Throws Error{file} when it is too small for its frame.
Mesh mesh_of(RawMesh raw, const MeshOptions& options, const std::filesystem::path& file);

}  // namespace luch::loader
