#pragma once

#include "framework/math/vec.h"
#include "framework/scene/loader/diagnostics.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace luch::loader {

/// Indices from 0; −1 where the face gives none.
struct ObjCorner {
    std::int64_t position = -1;
    std::int64_t uv = -1;
    std::int64_t normal = -1;
};
using ObjTriangle = std::array<ObjCorner, 3>;

/// What the lines of an OBJ file say; every index is within its array, every number finite.
struct ObjStatements {
    std::vector<Vec3d> positions;
    std::vector<Vec3d> normals;  ///< of any length, as written
    std::vector<Vec2d> uvs;
    std::vector<ObjTriangle> triangles;
};

/// Throws Error "file:line: …".
ObjStatements read_statements(std::string_view text, const std::string& file,
                              Diagnostics& diagnostics);

}  // namespace luch::loader
