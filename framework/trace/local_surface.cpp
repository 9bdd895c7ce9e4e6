#include "framework/trace/local_surface.h"

#include "framework/accel/heightfield_hit.h"

#include <numbers>

namespace luch {
namespace {

LocalSurface local_surface(const Plane& plane, const Ray& ray, const Hit& hit) {
    const auto exact = intersect(plane, ray);
    Vec3d p = ray.at(exact ? exact->t : hit.t);
    p.y = plane.y;
    const Vec3d up{0, 1, 0};
    return {p, up, up, {p.x, p.z}, {1, 0, 0}, {0, 0, 1}, max_norm(p)};
}

LocalSurface local_surface(const Sphere& sphere, const Ray& ray, const Hit& hit) {
    constexpr double pi = std::numbers::pi;
    const auto exact = intersect(sphere, ray);
    const Vec3d n = glm::normalize(ray.at(exact ? exact->t : hit.t) - sphere.centre);
    const Vec2d uv{std::atan2(n.z, n.x) / (2 * pi) + 0.5,
                   -(std::asin(std::clamp(n.y, -1.0, 1.0)) / pi + 0.5)};
    const double extent = max_norm(sphere.centre) + sphere.radius;
    return {sphere.centre + sphere.radius * n, n, n, uv * sphere.uv_scaling, {}, {}, extent};
}

LocalSurface local_surface(const Cube& cube, const Ray& ray, const Hit& hit) {
    const auto exact = intersect(cube, ray);
    const int axis = static_cast<int>(hit.primitive / 2);
    const double side = hit.primitive % 2 == 1 ? 1 : -1;
    Vec3d p = ray.at(exact ? exact->t : hit.t);
    p[axis] = cube.centre[axis] + side * cube.side / 2;
    Vec3d n{0};
    n[axis] = side;
    const Vec2d uv = axis == 0 ? Vec2d{p.y, p.z} : axis == 1 ? Vec2d{p.x, p.z} : Vec2d{p.x, p.y};
    return {p, n, n, uv, {}, {}, max_norm(cube.centre) + cube.side};
}

/// The two directions along which u and v grow; zero when the texture coordinates are degenerate.
void set_tangents(LocalSurface& surface, const Vec3d& edge1, const Vec3d& edge2, const Vec2d& uv1,
                  const Vec2d& uv2) {
    const double determinant = uv1.x * uv2.y - uv2.x * uv1.y;
    if (determinant == 0) return;
    surface.tangent_u = (edge1 * uv2.y - edge2 * uv1.y) / determinant;
    surface.tangent_v = (edge2 * uv1.x - edge1 * uv2.x) / determinant;
}

LocalSurface local_surface(const Mesh& mesh, const Ray&, const Hit& hit) {
    const Mesh::Triangle& triangle = mesh.triangles[hit.primitive];
    const Vec3d p0(mesh.corner(hit.primitive, 0));
    const Vec3d edge1 = Vec3d(mesh.corner(hit.primitive, 1)) - p0;
    const Vec3d edge2 = Vec3d(mesh.corner(hit.primitive, 2)) - p0;
    const double u = hit.u, v = hit.v, w = 1 - u - v;
    LocalSurface surface;
    surface.position = p0 + u * edge1 + v * edge2;
    surface.geometric_normal = surface.normal = glm::cross(edge1, edge2);
    surface.unit_roundoff = 0x1p-24;
    if (!mesh.normals.empty() && !mesh.faceted) {
        surface.normal = w * Vec3d(mesh.normals[triangle.normal[0]]) +
                         u * Vec3d(mesh.normals[triangle.normal[1]]) +
                         v * Vec3d(mesh.normals[triangle.normal[2]]);
    }
    if (!mesh.uvs.empty()) {
        const Vec2d uv0(mesh.uvs[triangle.uv[0]]);
        const Vec2d uv1 = Vec2d(mesh.uvs[triangle.uv[1]]) - uv0;
        const Vec2d uv2 = Vec2d(mesh.uvs[triangle.uv[2]]) - uv0;
        surface.uv = uv0 + u * uv1 + v * uv2;
        set_tangents(surface, edge1, edge2, uv1, uv2);
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

LocalSurface local_surface(const Heightfield& field, const Ray& ray, const Hit& hit) {
    const Heightfield::Triangle triangle = field.triangle(hit.primitive);
    const double exact = plane_t(field, triangle, ray);
    Vec3d p = ray.at(static_cast<float>(exact) == hit.t ? exact : hit.t);
    p.y = height_of(field, triangle, p.x, p.z);
    const double slope_x = height_of(field, triangle, 1, 0) - height_of(field, triangle, 0, 0);
    const double slope_z = height_of(field, triangle, 0, 1) - height_of(field, triangle, 0, 0);
    LocalSurface surface;
    surface.position = p;
    surface.geometric_normal = {-slope_x, 1, -slope_z};
    surface.normal = smooth_normal(field, triangle, p.x, p.z);
    surface.uv = {p.x / field.width(), p.z / field.height()};
    surface.tangent_u = {1, 0, 0};
    surface.tangent_v = {0, 0, 1};
    surface.extent = std::max({max_norm(p), double(field.width()), double(field.height())});
    return surface;
}

/// A part's surface, in the solid's coordinates. The ray is looked at from just before the hit on,
/// since the part's own first hit may be another one.
LocalSurface local_surface(const Csg& csg, const std::vector<Geometry>& geometries, const Ray& ray,
                           const Hit& hit) {
    const Csg::Part& part = csg.part_of(hit.primitive);
    Hit in_part = hit;
    in_part.primitive -= part.first_primitive;
    Ray from_here = part.to_frame.ray(ray);
    from_here.t_min = std::nextafter(hit.t, -std::numeric_limits<float>::infinity());
    LocalSurface surface = local_surface(geometries, part.geometry, from_here, in_part);
    surface.tangent_u = surface.tangent_v = Vec3d(0);
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

}  // namespace

LocalSurface local_surface(const std::vector<Geometry>& geometries, GeometryId geometry,
                           const Ray& ray, const Hit& hit) {
    const auto of_shape = [&](const auto& shape) {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Csg>) {
            return local_surface(shape, geometries, ray, hit);
        } else {
            return local_surface(shape, ray, hit);
        }
    };
    return std::visit(of_shape, geometries[geometry]);
}

}  // namespace luch
