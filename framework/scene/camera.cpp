#include "framework/scene/camera.h"

#include <numbers>

namespace luch {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double radians = pi / 180;

Camera eye_of(Camera camera, double along_right) {
    camera.position += along_right * camera.to_world().direction({1, 0, 0});
    camera.stereo_separation = 0;
    return camera;
}

/// Half of the frame's sides in the units of its projection.
Vec2d half_sides(const Camera& camera) {
    const double aspect = camera.aspect;
    switch (camera.projection) {
        case Projection::perspective: {
            const double half_height =
                std::tan(camera.fov_deg * pi / 360) / std::sqrt(aspect * aspect + 1);
            return {aspect * half_height, half_height};
        }
        case Projection::fisheye: {
            const double shorter = camera.fov_deg * radians / 2;
            return aspect > 1 ? Vec2d(shorter * aspect, shorter) : Vec2d(shorter, shorter / aspect);
        }
        case Projection::spherical:
            return {pi, pi / 2};
        case Projection::orthographic:
            return {camera.width / 2, camera.width / 2 / aspect};
    }
    return {};
}

}  // namespace

Transform Camera::to_world() const {
    return Transform::rotation(yaw_deg * radians, pitch_deg * radians, roll_deg * radians)
        .then(Transform::translation(position));
}

Camera Camera::left_eye() const {
    return eye_of(*this, -stereo_separation / 2);
}
Camera Camera::right_eye() const {
    return eye_of(*this, stereo_separation / 2);
}

Screen::Screen(const Camera& camera, Size size)
    : projection_(camera.projection),
      size_(size),
      eye_(camera.position),
      lens_radius_(camera.lens_radius()),
      focal_distance_(camera.focal_distance) {
    const Transform to_world = camera.to_world();
    right_ = to_world.direction({1, 0, 0});
    up_ = to_world.direction({0, 1, 0});
    forward_ = to_world.direction({0, 0, 1});
    const Vec2d half = half_sides(camera);
    half_width_ = half.x;
    half_height_ = half.y;
}

Ray Screen::ray(double x_px, double y_px) const {
    const double sx = across(x_px), sy = upwards(y_px);
    if (projection_ == Projection::orthographic) {
        return {eye_ + sx * right_ + sy * up_, forward_};
    }
    return {eye_, direction(sx, sy)};
}

Ray Screen::ray(double x_px, double y_px, const Vec2d& lens) const {
    if (lens_radius_ == 0) return ray(x_px, y_px);
    // The point in focus is focal · (forward + sx·right + sy·up); seen from the lens, and divided
    // by the focal distance.
    const Vec3d aside = lens_radius_ * (lens.x * right_ + lens.y * up_);
    const Vec3d to_focus =
        forward_ + across(x_px) * right_ + upwards(y_px) * up_ - aside / focal_distance_;
    return {eye_ + aside, glm::normalize(to_focus)};
}

Vec3d Screen::direction(double sx, double sy) const {
    switch (projection_) {
        case Projection::perspective:
            return glm::normalize(forward_ + sx * right_ + sy * up_);
        case Projection::fisheye:
            return fisheye_direction(sx, sy);
        case Projection::spherical:
            return spherical_direction(sx, sy);
        case Projection::orthographic:
            return forward_;
    }
    return {};
}

void Screen::directions(std::span<const double> sx, std::span<const double> sy, double* x,
                        double* y, double* z) const {
    if (projection_ != Projection::perspective) {
        for (std::size_t i = 0; i < sx.size(); ++i) {
            const Vec3d one = direction(sx[i], sy[i]);
            x[i] = one.x;
            y[i] = one.y;
            z[i] = one.z;
        }
        return;
    }
    // The operations of direction(); copies, as nothing that is written can change them.
    const Vec3d f = forward_, r = right_, u = up_;
    for (std::size_t i = 0; i < sx.size(); ++i) {
        const double dx = f.x + sx[i] * r.x + sy[i] * u.x;
        const double dy = f.y + sx[i] * r.y + sy[i] * u.y;
        const double dz = f.z + sx[i] * r.z + sy[i] * u.z;
        const double scale = 1 / std::sqrt(dx * dx + dy * dy + dz * dz);
        x[i] = dx * scale;
        y[i] = dy * scale;
        z[i] = dz * scale;
    }
}

Vec3d Screen::fisheye_direction(double sx, double sy) const {
    const double angle = std::hypot(sx, sy);
    if (angle > std::min(half_width_, half_height_)) return Vec3d(0);
    const double scale = angle > 0 ? std::sin(angle) / angle : 1;
    return glm::normalize(std::cos(angle) * forward_ + scale * (sx * right_ + sy * up_));
}

Vec3d Screen::spherical_direction(double sx, double sy) const {
    const double level = std::cos(sy);
    return glm::normalize(level * std::cos(sx) * forward_ + level * std::sin(sx) * right_ +
                          std::sin(sy) * up_);
}

Vec3d Screen::to_view(const Vec3d& world) const {
    const Vec3d p = world - eye_;
    return {glm::dot(p, right_), glm::dot(p, up_), glm::dot(p, forward_)};
}

std::optional<Vec2d> Screen::on_screen(const Vec3d& view) const {
    switch (projection_) {
        case Projection::perspective:
            if (!(view.z > 0)) return std::nullopt;
            return Vec2d{view.x / (view.z * half_width_), view.y / (view.z * half_height_)};
        case Projection::fisheye: {
            const double aside = std::hypot(view.x, view.y);
            const double angle = std::atan2(aside, view.z);
            if (!(angle <= std::min(half_width_, half_height_))) return std::nullopt;
            if (aside == 0) return view.z > 0 ? std::optional(Vec2d(0)) : std::nullopt;
            return Vec2d{angle * (view.x / aside) / half_width_,
                         angle * (view.y / aside) / half_height_};
        }
        case Projection::spherical:
            if (view == Vec3d(0)) return std::nullopt;
            return Vec2d{std::atan2(view.x, view.z) / half_width_,
                         std::atan2(view.y, std::hypot(view.x, view.z)) / half_height_};
        case Projection::orthographic:
            if (!(view.z > 0)) return std::nullopt;
            return Vec2d{view.x / half_width_, view.y / half_height_};
    }
    return std::nullopt;
}

std::optional<Vec2d> Screen::project(const Vec3d& view) const {
    const std::optional<Vec2d> at = on_screen(view);
    if (!at) return std::nullopt;
    return Vec2d{(at->x + 1) * 0.5 * size_.width, (1 - at->y) * 0.5 * size_.height};
}

}  // namespace luch
