#include "framework/window/fly.h"

#include <cmath>
#include <numbers>

namespace luch {
namespace {

/// Where a scene is only infinite planes: a stride over the course's scenes, which are some
/// hundreds of units wide.
constexpr double speed_without_bounds = 100;

double direction_of(bool positive, bool negative) {
    return (positive ? 1.0 : 0.0) - (negative ? 1.0 : 0.0);
}

}  // namespace

Camera flown(const Camera& camera, const FlyKeys& keys, double distance) {
    const Transform to_world = camera.to_world();
    const Vec3d way = to_world.direction({0, 0, 1}) * direction_of(keys.forward, keys.back) +
                      to_world.direction({1, 0, 0}) * direction_of(keys.right, keys.left) +
                      Vec3d(0, 1, 0) * direction_of(keys.up, keys.down);
    const double length = glm::length(way);
    if (!(length > 0)) return camera;
    Camera moved = camera;
    moved.position += way * (distance / length);
    return moved;
}

Camera turned(const Camera& camera, const Vec2d& drag_px, double degrees_per_px) {
    Camera moved = camera;
    if (drag_px.x != 0) {
        moved.yaw_deg = std::remainder(camera.yaw_deg - drag_px.x * degrees_per_px, 360.0);
    }
    if (drag_px.y != 0) {
        moved.pitch_deg = std::clamp(camera.pitch_deg - drag_px.y * degrees_per_px, -90.0, 90.0);
    }
    return moved;
}

double degrees_per_px(const Camera& camera, int width_px) {
    const double half_width = Screen(camera, {1, 1}).half_width();
    double half_angle = half_width;  // of a fisheye and a spherical camera
    if (camera.projection == Projection::perspective) half_angle = std::atan(half_width);
    if (camera.projection == Projection::orthographic) half_angle = std::numbers::pi / 4;
    return 2 * half_angle * 180 / std::numbers::pi / std::max(1, width_px);
}

double flying_speed(const Scene& scene) {
    std::vector<double> reaches;
    for (const Node& node : scene.nodes) {
        const Boxd box = node.to_world.box(bounds_of(scene.geometries[node.geometry]));
        if (box.empty() || !all_finite(box.lo) || !all_finite(box.hi)) continue;
        const double away = glm::distance(scene.camera.position, box.centre());
        const double reach = std::max(away, glm::length(box.size()) / 2);
        if (std::isfinite(reach) && reach > 0) reaches.push_back(reach);
    }
    if (reaches.empty()) return speed_without_bounds;
    const auto middle = reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() / 2);
    std::nth_element(reaches.begin(), middle, reaches.end());
    return *middle / 4;
}

}  // namespace luch
