#include "framework/trace/surface.h"

#include "framework/accel/node_hit.h"
#include "framework/accel/shapes.h"

#include <numbers>

namespace luch {
namespace {

/// What a shape knows of a point of its own, in its own coordinates. Lengths need not be 1.
struct LocalSurface {
    Vec3d position;
    Vec3d geometric_normal;
    Vec3d normal;
    Vec2d uv{0};
    Vec3d tangent_u{0}, tangent_v{0};  ///< ∂P/∂u, ∂P/∂v; zero where the shape has none
    double extent = 1;  ///< no coordinate of the shape is larger, as far as it matters here
    double unit_roundoff = 0x1p-53;  ///< 2⁻²⁴ where rays are traced in float
};

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

/// Unit length, or zero when there is no length to speak of.
Vec3d direction_of(const Vec3d& v) {
    const double size = max_norm(v);
    return size > 0 && std::isfinite(size) ? glm::normalize(v / size) : Vec3d(0);
}

Vec3d turned_against(const Vec3d& normal, const Vec3d& direction) {
    return glm::dot(normal, direction) > 0 ? -normal : normal;
}

}  // namespace

Surface surface_at(const Scene& scene, const Ray& ray, const Hit& hit, const SurfaceNeeds& needs) {
    const Node& node = scene.nodes[hit.node];
    const Ray object = to_object(ray, node);
    const LocalSurface local =
        std::visit([&](const auto& shape) { return local_surface(shape, object, hit); },
                   scene.geometries[node.geometry]);

    Surface surface;
    surface.node = hit.node;
    surface.position = node.to_world.point(local.position);
    if (needs.uv) surface.uv = local.uv;
    const Vec3d geometric = direction_of(node.to_object.normal_back(local.geometric_normal));
    Vec3d normal = direction_of(node.to_object.normal_back(local.normal));
    if (normal == Vec3d(0)) normal = geometric;
    if (needs.bump && node.bump != no_texture) {
        const Vec2d tilt = tilt_at(scene.textures[node.bump], local.uv);
        const Vec3d tilted = normal +
                             tilt.x * direction_of(node.to_world.direction(local.tangent_u)) +
                             tilt.y * direction_of(node.to_world.direction(local.tangent_v));
        if (max_norm(tilted) > 0) normal = glm::normalize(tilted);
    }
    surface.front = glm::dot(geometric, ray.direction) < 0;
    surface.geometric_normal = turned_against(geometric, ray.direction);
    surface.normal = turned_against(normal, ray.direction);

    // Some 16 roundings of coordinates no larger than these lie between the point and a ray's t.
    const double scale = max_norm(node.to_world.matrix);
    const double rounding = 16 * local.unit_roundoff;
    surface.error = rounding * scale * local.extent + 0x1p-48 * max_norm(surface.position);
    surface.error_per_distance = rounding * scale * max_norm(node.to_object.matrix);
    return surface;
}

Ray leaving(const Surface& surface, const Vec3d& direction) {
    const double side = glm::dot(direction, surface.geometric_normal) < 0 ? -1 : 1;
    return {surface.position + side * surface.error * surface.geometric_normal, direction};
}

Ray shadow_ray(const Surface& surface, const Vec3d& light_point) {
    const Vec3d to_light = light_point - surface.position;
    const double side = glm::dot(to_light, surface.geometric_normal) < 0 ? -1 : 1;
    const double lift = surface.error + surface.error_per_distance * glm::length(to_light);
    const Vec3d target = surface.position + side * lift * surface.geometric_normal;
    return {light_point, target - light_point, 0, 1};
}

}  // namespace luch
