#include "framework/accel/shapes.h"

namespace luch {
namespace {

/// The stretch of a ray inside a convex shape.
struct Stretch {
    ShapeHit in, out;
};

std::optional<ShapeHit> first_of(const std::optional<Stretch>& stretch, const Ray& ray) {
    if (!stretch) return std::nullopt;
    if (within(stretch->in.t, ray)) return stretch->in;
    if (within(stretch->out.t, ray)) return stretch->out;
    return std::nullopt;
}

void add_both(const std::optional<Stretch>& stretch, Crossings& crossings) {
    if (!stretch) return;
    crossings.add(stretch->in.t, stretch->in.primitive);
    crossings.add(stretch->out.t, stretch->out.primitive);
}

/// The t at which a ray meets the plane, where it does.
std::optional<double> t_on(const Plane& plane, const Ray& ray) {
    if (ray.direction.y == 0) return std::nullopt;
    const double t = (plane.y - ray.origin.y) / ray.direction.y;
    const Vec3d p = ray.at(t);
    if (!(std::abs(p.x) <= plane.limit && std::abs(p.z) <= plane.limit)) return std::nullopt;
    return t;
}

// The discriminant comes from the perpendicular distance of centre and ray, and the near root from
// the product of both, so that neither a small sphere far away nor a huge one close by loses its
// digits (Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems,
// 2019).
std::optional<Stretch> inside(const Sphere& sphere, const Ray& ray) {
    const Vec3d from_centre = ray.origin - sphere.centre;
    const double a = glm::dot(ray.direction, ray.direction);
    const double half_b = -glm::dot(from_centre, ray.direction);
    const Vec3d perpendicular = from_centre + (half_b / a) * ray.direction;
    const double discriminant =
        sphere.radius * sphere.radius - glm::dot(perpendicular, perpendicular);
    if (!(discriminant >= 0)) return std::nullopt;
    const double distance = glm::length(from_centre);
    const double product = (distance - sphere.radius) * (distance + sphere.radius);
    const double q = half_b + std::copysign(std::sqrt(a * discriminant), half_b);
    const double one = q / a, other = q != 0 ? product / q : one;
    return Stretch{{std::min(one, other), 0}, {std::max(one, other), 0}};
}

std::optional<Stretch> inside(const Cube& cube, const Ray& ray) {
    const Boxd box = bounds_of(cube);
    ShapeHit in{-std::numeric_limits<double>::infinity(), 0};
    ShapeHit out{std::numeric_limits<double>::infinity(), 0};
    for (int axis = 0; axis < 3; ++axis) {
        const bool negative = std::signbit(ray.direction[axis]);
        const double inverse = 1 / ray.direction[axis];
        const double first = negative ? box.hi[axis] : box.lo[axis];
        const double last = negative ? box.lo[axis] : box.hi[axis];
        const double near = (first - ray.origin[axis]) * inverse;
        const double far = (last - ray.origin[axis]) * inverse;
        // A ray that runs in a face gives 0 · ∞ = NaN, which no comparison takes.
        if (near > in.t) in = {near, 2u * axis + (negative ? 1u : 0u)};
        if (far < out.t) out = {far, 2u * axis + (negative ? 0u : 1u)};
    }
    if (!(in.t <= out.t)) return std::nullopt;
    return Stretch{in, out};
}

}  // namespace

std::optional<ShapeHit> intersect(const Plane& plane, const Ray& ray) {
    const auto t = t_on(plane, ray);
    return t && within(*t, ray) ? std::optional(ShapeHit{*t, 0}) : std::nullopt;
}

std::optional<ShapeHit> intersect(const Sphere& sphere, const Ray& ray) {
    return first_of(inside(sphere, ray), ray);
}

std::optional<ShapeHit> intersect(const Cube& cube, const Ray& ray) {
    return first_of(inside(cube, ray), ray);
}

void find_crossings(const Plane& plane, const Ray& ray, Crossings& crossings) {
    if (const auto t = t_on(plane, ray)) crossings.add(*t, 0);
}

void find_crossings(const Sphere& sphere, const Ray& ray, Crossings& crossings) {
    add_both(inside(sphere, ray), crossings);
}

void find_crossings(const Cube& cube, const Ray& ray, Crossings& crossings) {
    add_both(inside(cube, ray), crossings);
}

}  // namespace luch
