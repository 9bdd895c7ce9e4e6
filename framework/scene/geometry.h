#pragma once

#include "framework/math/bounds.h"
#include "framework/math/transform.h"
#include "framework/scene/csg.h"
#include "framework/scene/heightfield.h"

#include <array>
#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

namespace luch {

/// The plane y = const, or the square of it with |x|, |z| ≤ limit.
struct Plane {
    double y = 0;
    double limit = std::numeric_limits<double>::infinity();
};

struct Sphere {
    Vec3d centre{0};
    double radius = 1;
    double uv_scaling = 1;
};

/// An axis-aligned cube; `side` is the full edge.
struct Cube {
    Vec3d centre{0};
    double side = 1;
};

/// Triangles, stored in float in a frame of their own: the centre is subtracted in double and the
/// extent scaled by a power of two to about 1. from_frame leads back to the file's coordinates.
struct Mesh {
    struct Triangle {
        std::array<std::uint32_t, 3> position;
        std::array<std::uint32_t, 3> normal;  ///< meaningful only where normals is not empty
        std::array<std::uint32_t, 3> uv;      ///< meaningful only where uvs is not empty
    };
    std::vector<Vec3> positions;  ///< in the mesh's own frame
    std::vector<Vec3> normals;    ///< unit length
    std::vector<Vec2> uvs;
    std::vector<Triangle> triangles;
    /// Of each triangle, where the mesh's file has materials of its own (glTF); else empty. Seen
    /// only by nodes that ask for them: materials_of_file.
    std::vector<std::uint32_t> materials;
    Transform from_frame;
    bool faceted = false;
    bool cull_backfaces = false;

    [[nodiscard]] const Vec3& corner(std::uint32_t triangle, int which) const {
        return positions[triangles[triangle].position[which]];
    }
    [[nodiscard]] Box box(std::uint32_t triangle) const {
        Box box;
        for (int k = 0; k < 3; ++k) box.grow(corner(triangle, k));
        return box;
    }
};

/// Moves the positions (in the file's coordinates, double) into the mesh's own frame.
void set_positions(Mesh& mesh, const std::vector<Vec3d>& positions);

using Geometry = std::variant<Plane, Sphere, Cube, Mesh, Heightfield, Csg>;

/// In the coordinates that a node's to_world starts from (a mesh's own frame, else the file's).
Boxd bounds_of(const Geometry& geometry);

/// Hit::primitive of a geometry is below this.
std::uint32_t primitive_count(const Geometry& geometry);

/// The solid of two geometries, which may be solids too; they must stand in `geometries`. Throws
/// std::length_error when it unfolds to more than Csg::most_parts parts, or to more primitives than
/// a Hit can count.
Csg make_csg(Csg::Operation operation, GeometryId left, GeometryId right,
             const std::vector<Geometry>& geometries);

}  // namespace luch
