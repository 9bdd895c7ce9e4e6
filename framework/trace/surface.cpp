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

/// A normal that a node's bump tilts.
Vec3d bumped(const Scene& scene, const Node& node, const Hit& hit, const Vec2d& uv,
             const Vec3d& normal) {
    const Tangents along = local_tangents(scene.geometries[node.geometry], hit);
    if (node.bump == no_texture) return normal;
    const Vec2d tilt = tilt_at(scene.textures[node.bump], uv);
    const Vec3d tilted = normal + tilt.x * direction_of(node.to_world.direction(along.u)) +
                         tilt.y * direction_of(node.to_world.direction(along.v));
    return max_norm(tilted) > 0 ? glm::normalize(tilted) : normal;
}

/// A part that is counted when it is needed.
bool at_work(Part part, const Needs& needs, Counts& counts) {
    if (!needs[part]) return false;
    counts.did(part);
    return true;
}

/// What looks at single kinds of shapes, for the counts.
void count_shape(const Geometry& geometry, const Needs& needs, Counts& counts) {
    if (needs[Part::solids] && std::holds_alternative<Csg>(geometry)) counts.did(Part::solids);
    if (needs[Part::heightfields] && std::holds_alternative<Heightfield>(geometry)) {
        counts.did(Part::heightfields);
    }
}

}  // namespace

Surface surface_at(const Scene& scene, const Ray& ray, const Hit& hit) {
    Counts not_counted;
    return surface_at(scene, ray, hit, Needs(), not_counted);
}

Surface surface_at(const Scene& scene, const Ray& ray, const Hit& hit, const Needs& needs,
                   Counts& counts) {
    const Node& node = scene.nodes[hit.node];
    count_shape(scene.geometries[node.geometry], needs, counts);
    const bool moved = at_work(Part::transforms, needs, counts);
    const bool smooth = at_work(Part::smooth_normals, needs, counts);
    const LocalSurface local = local_surface(scene.geometries, node.geometry,
                                             moved ? to_object(ray, node) : ray, hit, smooth);
    const auto normal_in_world = [&](const Vec3d& n) {
        return direction_of(moved ? node.to_object.normal_back(n) : n);
    };
    Surface surface;
    surface.node = hit.node;
    surface.position = moved ? node.to_world.point(local.position) : local.position;
    if (at_work(Part::texture_coordinates, needs, counts)) {
        surface.uv = local_uv(scene.geometries, node.geometry, local, hit);
    }
    const Vec3d geometric = normal_in_world(local.geometric_normal);
    Vec3d normal = normal_in_world(local.normal);
    if (normal == Vec3d(0)) normal = geometric;
    if (at_work(Part::bump, needs, counts)) normal = bumped(scene, node, hit, surface.uv, normal);
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
