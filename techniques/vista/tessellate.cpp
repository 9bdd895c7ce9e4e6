#include "techniques/vista/vista.h"

#include <numbers>

namespace luch::techniques::vista {
namespace {

using Triangles = std::vector<Tri>;

void add(Triangles& triangles, const Corner& a, const Corner& b, const Corner& c) {
    triangles.push_back({{a, b, c}, no_node});
}

/// The points where meridians and parallels cross: n meridians, n/2 bands from pole to pole. They
/// lie on the sphere, so the polyhedron is inside it (inscribed) and its silhouette too small.
void add(Triangles& triangles, const Sphere& sphere, int n) {
    const int bands = n / 2;
    std::vector<Corner> grid;
    for (int band = 0; band <= bands; ++band) {
        const bool pole = band == 0 || band == bands;
        const double latitude = std::numbers::pi * band / bands;
        const double ring = pole ? 0 : std::sin(latitude);
        for (int i = 0; i < n; ++i) {
            const double longitude = 2 * std::numbers::pi * i / n;
            const Vec3d unit{ring * std::cos(longitude), std::cos(latitude),
                             ring * std::sin(longitude)};
            grid.push_back({sphere.centre + sphere.radius * unit});
        }
    }
    const auto at = [&](int band, int i) {
        return grid[static_cast<std::size_t>(band * n + i % n)];
    };
    for (int band = 0; band < bands; ++band) {
        for (int i = 0; i < n; ++i) {
            if (band > 0) add(triangles, at(band, i), at(band, i + 1), at(band + 1, i));
            if (band < bands - 1)
                add(triangles, at(band, i + 1), at(band + 1, i + 1), at(band + 1, i));
        }
    }
}

/// A square is two triangles. The infinite plane is four: a quarter of it is the triangle of the
/// origin, the end of one axis and the end of the other, both at infinity. Nothing of it is lost.
void add(Triangles& triangles, const Plane& plane, int) {
    const double y = plane.y, r = plane.limit;
    if (std::isinf(r)) {
        const Corner origin{{0, y, 0}};
        const std::array<Corner, 4> ends{
            {{{1, 0, 0}, 0}, {{0, 0, 1}, 0}, {{-1, 0, 0}, 0}, {{0, 0, -1}, 0}}};
        for (std::size_t i = 0; i < 4; ++i) add(triangles, origin, ends[i], ends[(i + 1) % 4]);
        return;
    }
    const Corner a{{-r, y, -r}}, b{{r, y, -r}}, c{{r, y, r}}, d{{-r, y, r}};
    add(triangles, a, b, c);
    add(triangles, a, c, d);
}

/// Two triangles a face; bit k of a corner's number says on which side of axis k it lies.
void add_box(Triangles& triangles, const Boxd& box) {
    const auto corner = [&](int bits) {
        return Corner{{bits & 1 ? box.hi.x : box.lo.x, bits & 2 ? box.hi.y : box.lo.y,
                       bits & 4 ? box.hi.z : box.lo.z}};
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
        for (const int face : {0, 1 << axis}) {
            add(triangles, corner(face), corner(face | u), corner(face | u | v));
            add(triangles, corner(face), corner(face | u | v), corner(face | v));
        }
    }
}

void add(Triangles& triangles, const Cube& cube, int) {
    add_box(triangles, bounds_of(cube));
}

void add(Triangles& triangles, const Mesh& mesh, int) {
    triangles.reserve(mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto corner = [&](int k) { return Corner{Vec3d(mesh.corner(i, k))}; };
        add(triangles, corner(0), corner(1), corner(2));
    }
}

void add(Triangles& triangles, const Heightfield& field, int) {
    triangles.reserve(primitive_count(field));
    const auto at = [&](int x, int z) { return Corner{Vec3d(x, field.at(x, z), z)}; };
    for (int z = 0; z < field.height(); ++z) {
        for (int x = 0; x < field.width(); ++x) {
            add(triangles, at(x, z), at(x + 1, z), at(x, z + 1));
            add(triangles, at(x + 1, z), at(x + 1, z + 1), at(x, z + 1));
        }
    }
}

/// A solid has no triangles of its own: the sides of its box stand for it. Rays that meet the box
/// and not the solid fall back.
void add(Triangles& triangles, const Csg& csg, int) {
    if (csg.bounds.empty()) return;
    add_box(triangles, csg.bounds);
}

}  // namespace

void tessellate(const Geometry& geometry, int n, std::vector<Tri>& triangles) {
    triangles.clear();
    std::visit([&](const auto& shape) { add(triangles, shape, n); }, geometry);
}

}  // namespace luch::techniques::vista
