#include "framework/trace/rect_sampler.h"

#include <numbers>

namespace luch {
namespace {

/// Below this the angles of the spherical rectangle have lost too many of their 53 bits.
constexpr double least_solid_angle = 1e-6;
/// The cosine between the square's edges from which on it counts as sheared.
constexpr double least_shear = 1e-9;

double hyperbolic(double a, double z) {
    return a / std::sqrt(a * a + z * z);
}

}  // namespace

RectSampler::RectSampler(const RectLight& light)
    : edge_x_(light.to_world.direction({1, 0, 0})),
      edge_y_(light.to_world.direction({0, 0, 1})),
      length_x_(glm::length(edge_x_)),
      length_y_(glm::length(edge_y_)),
      area_(glm::length(glm::cross(edge_x_, edge_y_))),
      facing_(light.facing()) {
    corner_ = light.to_world.point({-0.5, 0, -0.5});
    axis_x_ = edge_x_ / length_x_;
    axis_y_ = edge_y_ / length_y_;
    rectangle_ = std::abs(glm::dot(axis_x_, axis_y_)) < least_shear;
    radiance_ = Vec3d(light.color) * (static_cast<double>(light.power) / area_);
    lift_ = 0x1p-44 * (max_norm(corner_) + max_norm(light.to_world.matrix));
}

std::optional<RectSample> RectSampler::sample(const Vec3d& from, const Vec2d& square) const {
    if (!(glm::dot(facing_, from - corner_) > 0)) return std::nullopt;
    const auto seen = view(from);
    RectSample sample;
    sample.place =
        seen ? spherical_place(*seen, square) : corner_ + square.x * edge_x_ + square.y * edge_y_;
    sample.pdf = seen ? 1 / seen->solid_angle : area_pdf(from, sample.place);
    sample.place += lift_ * facing_;
    const Vec3d way = sample.place - from;
    const double distance = glm::length(way);
    if (!(distance > 0) || !(sample.pdf > 0) || !std::isfinite(sample.pdf)) return std::nullopt;
    sample.direction = way / distance;
    return sample;
}

double RectSampler::pdf(const Vec3d& from, const Vec3d& place) const {
    const auto seen = view(from);
    return seen ? 1 / seen->solid_angle : area_pdf(from, place);
}

double RectSampler::area_pdf(const Vec3d& from, const Vec3d& place) const {
    const Vec3d way = from - place;
    const double square = glm::dot(way, way);
    const double cosine = glm::dot(facing_, way) / std::sqrt(square);
    return cosine > 0 ? square / (area_ * cosine) : 0;
}

std::optional<RectSampler::View> RectSampler::view(const Vec3d& from) const {
    if (!rectangle_) return std::nullopt;
    const Vec3d to_corner = corner_ - from;
    View v{};
    v.x0 = glm::dot(to_corner, axis_x_);
    v.y0 = glm::dot(to_corner, axis_y_);
    v.z = -std::abs(glm::dot(to_corner, facing_));
    v.x1 = v.x0 + length_x_;
    v.y1 = v.y0 + length_y_;
    v.tx0 = hyperbolic(v.x0, v.z);
    v.tx1 = hyperbolic(v.x1, v.z);
    v.ty0 = hyperbolic(v.y0, v.z);
    v.ty1 = hyperbolic(v.y1, v.z);
    // The four inner angles less 2π, each as π/2 − asin: what cancels is never computed.
    v.solid_angle = std::asin(v.tx1 * v.ty1) - std::asin(v.tx1 * v.ty0) - std::asin(v.tx0 * v.ty1) +
                    std::asin(v.tx0 * v.ty0);
    if (!(v.solid_angle > least_solid_angle)) return std::nullopt;
    return v;
}

Vec3d RectSampler::spherical_place(const View& v, const Vec2d& square) const {
    // x such that the part of the rectangle left of it covers square.x of the solid angle.
    const double inner =
        2 * std::numbers::pi - std::acos(v.tx0 * v.ty1) - std::acos(-v.tx0 * v.ty0);
    const double angle = square.x * v.solid_angle + inner;
    const double f = (std::cos(angle) * -v.ty0 - v.ty1) / std::sin(angle);
    const double c = std::copysign(1 / std::sqrt(f * f + v.ty0 * v.ty0), f);
    double x = -c * v.z / std::sqrt(std::max(0.0, 1 - c * c));
    if (!(x >= v.x0)) x = v.x0;
    if (x > v.x1) x = v.x1;
    // y such that its sine's height on the sphere is uniform.
    const double d = std::sqrt(x * x + v.z * v.z);
    const double h0 = hyperbolic(v.y0, d), h1 = hyperbolic(v.y1, d);
    const double h = h0 + square.y * (h1 - h0);
    const double y = std::clamp(h * d / std::sqrt(std::max(0x1p-60, 1 - h * h)), v.y0, v.y1);
    return corner_ + (x - v.x0) * axis_x_ + (y - v.y0) * axis_y_;
}

}  // namespace luch
