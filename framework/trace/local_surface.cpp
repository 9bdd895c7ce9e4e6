#include "framework/trace/local_surface.h"

#include "framework/accel/heightfield_hit.h"

#include <numbers>

namespace luch {
namespace {

LocalSurface local_surface(const Plane& plane, const Ray& ray, const Hit& hit, bool) {
    const auto exact = intersect(plane, ray);
    Vec3d p = ray.at(exact ? exact->t : hit.t);
    p.y = plane.y;
    const Vec3d up{0, 1, 0};
    return {p, up, up, max_norm(p)};
}

LocalSurface local_surface(const Sphere& sphere, const Ray& ray, const Hit& hit, bool) {
    const auto exact = intersect(sphere, ray);
    const Vec3d n = glm::normalize(ray.at(exact ? exact->t : hit.t) - sphere.centre);
    const double extent = max_norm(sphere.centre) + sphere.radius;
    return {sphere.centre + sphere.radius * n, n, n, extent};
}

LocalSurface local_surface(const Cube& cube, const Ray& ray, const Hit& hit, bool) {
    const auto exact = intersect(cube, ray);
    const int axis = static_cast<int>(hit.primitive / 2);
    const double side = hit.primitive % 2 == 1 ? 1 : -1;
    Vec3d p = ray.at(exact ? exact->t : hit.t);
    p[axis] = cube.centre[axis] + side * cube.side / 2;
    Vec3d n{0};
    n[axis] = side;
    return {p, n, n, max_norm(cube.centre) + cube.side};
}

/// From a triangle's first corner to the others.
struct Edges {
    Vec3d first, second;
};
Edges edges_of(const Mesh& mesh, std::uint32_t triangle) {
    const Vec3d p0(mesh.corner(triangle, 0));
    return {Vec3d(mesh.corner(triangle, 1)) - p0, Vec3d(mesh.corner(triangle, 2)) - p0};
}

/// The texture coordinates of a triangle's first corner, and from there to the others.
struct UvEdges {
    Vec2d start, first, second;
};
UvEdges uv_edges_of(const Mesh& mesh, std::uint32_t triangle) {
    const auto& corners = mesh.triangles[triangle].uv;
    const Vec2d start(mesh.uvs[corners[0]]);
    return {start, Vec2d(mesh.uvs[corners[1]]) - start, Vec2d(mesh.uvs[corners[2]]) - start};
}

LocalSurface local_surface(const Mesh& mesh, const Ray&, const Hit& hit, bool smooth) {
    const Mesh::Triangle& triangle = mesh.triangles[hit.primitive];
    const Edges edges = edges_of(mesh, hit.primitive);
    const double u = hit.u, v = hit.v, w = 1 - u - v;
    LocalSurface surface;
    surface.position = Vec3d(mesh.corner(hit.primitive, 0)) + u * edges.first + v * edges.second;
    surface.geometric_normal = surface.normal = glm::cross(edges.first, edges.second);
    surface.unit_roundoff = 0x1p-24;
    if (smooth && !mesh.normals.empty() && !mesh.faceted) {
        surface.normal = w * Vec3d(mesh.normals[triangle.normal[0]]) +
                         u * Vec3d(mesh.normals[triangle.normal[1]]) +
                         v * Vec3d(mesh.normals[triangle.normal[2]]);
    }
    return surface;
}

/// The normals of the cell's four corners, mixed: bilinear.
Vec3d smooth_normal(const Heightfield& field, const Heightfield::Triangle& triangle, double x,
                    double z) {
    const auto mixed = [](const Vec3d& a, const Vec3d& b, double share) {
        return a + std::clamp(share, 0.0, 1.0) * (b - a);
    };
    const int x0 = triangle.x, z0 = triangle.z;
    return mixed(mixed(field.normal(x0, z0), field.normal(x0 + 1, z0), x - x0),
                 mixed(field.normal(x0, z0 + 1), field.normal(x0 + 1, z0 + 1), x - x0), z - z0);
}

LocalSurface local_surface(const Heightfield& field, const Ray& ray, const Hit& hit, bool smooth) {
    const Heightfield::Triangle triangle = field.triangle(hit.primitive);
    const double exact = plane_t(field, triangle, ray);
    Vec3d p = ray.at(static_cast<float>(exact) == hit.t ? exact : hit.t);
    p.y = height_of(field, triangle, p.x, p.z);
    const double slope_x = height_of(field, triangle, 1, 0) - height_of(field, triangle, 0, 0);
    const double slope_z = height_of(field, triangle, 0, 1) - height_of(field, triangle, 0, 0);
    LocalSurface surface;
    surface.position = p;
    surface.geometric_normal = {-slope_x, 1, -slope_z};
    surface.normal = smooth ? smooth_normal(field, triangle, p.x, p.z) : surface.geometric_normal;
    surface.extent = std::max({max_norm(p), double(field.width()), double(field.height())});
    return surface;
}

Hit in_part(const Csg::Part& part, Hit hit) {
    hit.primitive -= part.first_primitive;
    return hit;
}

/// A part's surface, in the solid's coordinates. The ray is looked at from just before the hit on,
/// since the part's own first hit may be another one.
LocalSurface local_surface(const Csg& csg, const std::vector<Geometry>& geometries, const Ray& ray,
                           const Hit& hit, bool smooth) {
    const Csg::Part& part = csg.part_of(hit.primitive);
    Ray from_here = part.to_frame.ray(ray);
    from_here.t_min = std::nextafter(hit.t, -std::numeric_limits<float>::infinity());
    LocalSurface surface =
        local_surface(geometries, part.geometry, from_here, in_part(part, hit), smooth);
    if (const auto* mesh = std::get_if<Mesh>(&geometries[part.geometry])) {
        surface.position = mesh->from_frame.point(surface.position);
        surface.geometric_normal = part.to_frame.normal_back(surface.geometric_normal);
        surface.normal = part.to_frame.normal_back(surface.normal);
        surface.extent *= max_norm(mesh->from_frame.matrix);
    }
    if (part.flipped) {
        surface.geometric_normal = -surface.geometric_normal;
        surface.normal = -surface.normal;
    }
    return surface;
}

Vec2d uv_of(const Plane&, const LocalSurface& surface, const Hit&) {
    return {surface.position.x, surface.position.z};
}

Vec2d uv_of(const Sphere& sphere, const LocalSurface& surface, const Hit&) {
    constexpr double pi = std::numbers::pi;
    const Vec3d& n = surface.normal;
    const Vec2d uv{std::atan2(n.z, n.x) / (2 * pi) + 0.5,
                   -(std::asin(std::clamp(n.y, -1.0, 1.0)) / pi + 0.5)};
    return uv * sphere.uv_scaling;
}

Vec2d uv_of(const Cube&, const LocalSurface& surface, const Hit& hit) {
    const Vec3d& p = surface.position;
    const std::uint32_t axis = hit.primitive / 2;
    return axis == 0 ? Vec2d{p.y, p.z} : axis == 1 ? Vec2d{p.x, p.z} : Vec2d{p.x, p.y};
}

Vec2d uv_of(const Mesh& mesh, const LocalSurface&, const Hit& hit) {
    if (mesh.uvs.empty()) return Vec2d(0);
    const UvEdges uv = uv_edges_of(mesh, hit.primitive);
    return uv.start + double{hit.u} * uv.first + double{hit.v} * uv.second;
}

Vec2d uv_of(const Heightfield& field, const LocalSurface& surface, const Hit&) {
    return {surface.position.x / field.width(), surface.position.z / field.height()};
}

Vec2d uv_of(const Csg& csg, const std::vector<Geometry>& geometries, LocalSurface surface,
            const Hit& hit) {
    const Csg::Part& part = csg.part_of(hit.primitive);
    if (part.flipped) surface.normal = -surface.normal;
    return local_uv(geometries, part.geometry, surface, in_part(part, hit));
}

}  // namespace

Vec2d local_uv(const std::vector<Geometry>& geometries, GeometryId geometry,
               const LocalSurface& surface, const Hit& hit) {
    const auto of_shape = [&](const auto& shape) {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Csg>) {
            return uv_of(shape, geometries, surface, hit);
        } else {
            return uv_of(shape, surface, hit);
        }
    };
    return std::visit(of_shape, geometries[geometry]);
}

Tangents local_tangents(const Geometry& geometry, const Hit& hit) {
    if (std::holds_alternative<Plane>(geometry) || std::holds_alternative<Heightfield>(geometry)) {
        return {{1, 0, 0}, {0, 0, 1}};
    }
    const auto* mesh = std::get_if<Mesh>(&geometry);
    if (mesh == nullptr || mesh->uvs.empty()) return {};
    const Edges edges = edges_of(*mesh, hit.primitive);
    const UvEdges uv = uv_edges_of(*mesh, hit.primitive);
    const double determinant = uv.first.x * uv.second.y - uv.second.x * uv.first.y;
    if (determinant == 0) return {};
    return {(edges.first * uv.second.y - edges.second * uv.first.y) / determinant,
            (edges.second * uv.first.x - edges.first * uv.second.x) / determinant};
}

LocalSurface local_surface(const std::vector<Geometry>& geometries, GeometryId geometry,
                           const Ray& ray, const Hit& hit, bool smooth) {
    const auto of_shape = [&](const auto& shape) {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Csg>) {
            return local_surface(shape, geometries, ray, hit, smooth);
        } else {
            return local_surface(shape, ray, hit, smooth);
        }
    };
    return std::visit(of_shape, geometries[geometry]);
}

}  // namespace luch
