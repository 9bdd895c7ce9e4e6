#pragma once

#include "framework/math/vec.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace luch::assets {

/// One connected surface: corners index `points` (with their normals) and `uvs` apart, so that a
/// texture's seam splits no point.
struct Surface {
    struct Corner {
        std::uint32_t point;
        std::uint32_t uv;
    };
    using Triangle = std::array<Corner, 3>;

    std::string_view name;
    std::vector<Vec3d> points;
    std::vector<Vec3d> normals;  ///< one a point, length 1, outward
    std::vector<Vec2d> uvs;
    std::vector<Triangle> triangles;  ///< (B−A)×(C−A) points outward
};

/// Newell's teapot with every patch cut into segments × segments quads (≥ 1), as four surfaces:
/// body, lid, handle, spout. 64·segments² − 8·segments triangles, since the quads at the knob and
/// in the middle of the bottom are triangles. u runs around each surface, to the
/// right as seen from outside, v along it, downwards on body and lid, both from 0 to 1.
std::vector<Surface> teapot(int segments);

/// Wavefront OBJ: positions with 5 decimals, normals and uvs with 4; `comment` becomes its first
/// line.
std::string obj_text(const std::vector<Surface>& surfaces, std::string_view comment);

}  // namespace luch::assets
