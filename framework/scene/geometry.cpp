#include "framework/scene/geometry.h"

#include <cmath>

namespace luch {
namespace {

Boxd box_of(const Plane& plane) {
    return {{-plane.limit, plane.y, -plane.limit}, {plane.limit, plane.y, plane.limit}};
}
Boxd box_of(const Sphere& sphere) {
    return {sphere.centre - sphere.radius, sphere.centre + sphere.radius};
}
Boxd box_of(const Cube& cube) {
    return {cube.centre - cube.side / 2, cube.centre + cube.side / 2};
}
Boxd box_of(const Mesh& mesh) {
    Boxd box;
    for (const auto& triangle : mesh.triangles) {
        for (const auto i : triangle.position) box.grow(Vec3d(mesh.positions[i]));
    }
    return box;
}
Boxd box_of(const Heightfield& field) {
    const auto [lo, hi] = field.range(field.top_level(), 0, 0);
    return {{0, lo, 0}, {field.width(), hi, field.height()}};
}
Boxd box_of(const Csg& csg) {
    return csg.bounds;
}

std::uint32_t primitives_of(const Plane&) {
    return 1;
}
std::uint32_t primitives_of(const Sphere&) {
    return 1;
}
std::uint32_t primitives_of(const Cube&) {
    return 6;
}
std::uint32_t primitives_of(const Mesh& mesh) {
    return static_cast<std::uint32_t>(mesh.triangles.size());
}
std::uint32_t primitives_of(const Heightfield& field) {
    return field.primitive(field.width() - 1, field.height() - 1, 1) + 1;
}
std::uint32_t primitives_of(const Csg& csg) {
    return csg.primitives;
}

}  // namespace

void set_positions(Mesh& mesh, const std::vector<Vec3d>& positions) {
    Boxd box;
    for (const Vec3d& p : positions) box.grow(p);
    const Vec3d centre = box.empty() ? Vec3d(0) : box.centre();
    const double extent = box.empty() ? 0 : max_norm(box.size());
    const double scale = extent > 0 ? std::ldexp(1.0, -std::ilogb(extent)) : 1;
    mesh.positions.clear();
    mesh.positions.reserve(positions.size());
    for (const Vec3d& p : positions) mesh.positions.emplace_back((p - centre) * scale);
    mesh.from_frame = Transform::scaling(Vec3d(1 / scale)).then(Transform::translation(centre));
}

Boxd bounds_of(const Geometry& geometry) {
    return std::visit([](const auto& shape) { return box_of(shape); }, geometry);
}

std::uint32_t primitive_count(const Geometry& geometry) {
    return std::visit([](const auto& shape) { return primitives_of(shape); }, geometry);
}

}  // namespace luch
