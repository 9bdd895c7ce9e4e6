#include "framework/trace/surface.h"

#include "framework/accel/node_hit.h"
#include "framework/trace/local_surface.h"

namespace luch {
namespace {

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
    const LocalSurface local = local_surface(scene.geometries, node.geometry, object, hit);

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
