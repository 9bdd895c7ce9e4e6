#include "framework/scene/camera.h"

#include <numbers>

namespace luch {

Transform Camera::to_world() const {
    constexpr double radians = std::numbers::pi / 180;
    return Transform::rotation(yaw_deg * radians, pitch_deg * radians, roll_deg * radians)
        .then(Transform::translation(position));
}

Screen::Screen(const Camera& camera, Size size) : size_(size), eye_(camera.position) {
    const Transform to_world = camera.to_world();
    right_ = to_world.direction({1, 0, 0});
    up_ = to_world.direction({0, 1, 0});
    forward_ = to_world.direction({0, 0, 1});
    const double half_diagonal = std::tan(camera.fov_deg * std::numbers::pi / 360);
    half_height_ = half_diagonal / std::sqrt(camera.aspect * camera.aspect + 1);
    half_width_ = camera.aspect * half_height_;
}

Ray Screen::ray(double x_px, double y_px) const {
    const double sx = (2 * x_px / size_.width - 1) * half_width_;
    const double sy = (1 - 2 * y_px / size_.height) * half_height_;
    return {eye_, glm::normalize(forward_ + sx * right_ + sy * up_)};
}

Vec3d Screen::to_view(const Vec3d& world) const {
    const Vec3d p = world - eye_;
    return {glm::dot(p, right_), glm::dot(p, up_), glm::dot(p, forward_)};
}

std::optional<Vec2d> Screen::project(const Vec3d& view) const {
    if (!(view.z > 0)) return std::nullopt;
    return Vec2d{(view.x / (view.z * half_width_) + 1) * 0.5 * size_.width,
                 (1 - view.y / (view.z * half_height_)) * 0.5 * size_.height};
}

}  // namespace luch
