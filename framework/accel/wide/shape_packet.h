#pragma once

#include "framework/accel/wide/kernels.h"
#include "framework/accel/wide/lanes.h"

#include <cmath>

// The shape tests of shapes.cpp for the rays of a packet: the same operations in the same order, in
// loops without branches that a compiler turns into lanes. Only kernel files include this; nothing
// here has linkage.
namespace luch::wide {
namespace {

using Column = double[RayPacket::capacity];

/// shape_ray()'s rule for one number.
[[gnu::always_inline]] inline double worth_keeping(double x) {
    return std::abs(x) < 0x1p-500 ? std::copysign(0.0, x) : x;
}

/// The directions in the shape's coordinates.
struct ShapeDirections {
    alignas(64) Column x, y, z;

    explicit ShapeDirections(const ShapeRays& rays) {
        const RayPacket& from = *rays.packet;
        Column* const to[3] = {&x, &y, &z};
        for (int axis = 0; axis < 3; ++axis) {
            Column& out = *to[axis];
            if (rays.to_object == nullptr) {
                const double* const in = axis == 0 ? from.x : axis == 1 ? from.y : from.z;
                for (int i = 0; i < from.count; ++i) out[i] = worth_keeping(in[i]);
                continue;
            }
            const auto& m = rays.to_object->matrix[axis];
            const double mx = m[0], my = m[1], mz = m[2];
            for (int i = 0; i < from.count; ++i) {
                out[i] = worth_keeping(from.x[i] * mx + from.y[i] * my + from.z[i] * mz);
            }
        }
    }
};

/// Where rays enter and leave a shape; NaN where they miss it.
struct Stretches {
    alignas(64) Column in, out;
};

/// Keeps, of each stretch, the first end that counts; a ray that looks for nothing, is not finite
/// or has no direction meets nothing. See within() and is_sound(). Faces become 1 where the ray
/// enters, else 0.
void keep_first(const Stretches& at, const RayPacket& rays, ShapeHits& hits) {
    const float least = least_t(rays.t_min);
    for (int i = 0; i < rays.count; ++i) {
        const float in = static_cast<float>(at.in[i]), out = static_cast<float>(at.out[i]);
        const float most = rays.t_max[i];
        const bool first = (in > least) & (in < most), second = (out > least) & (out < most);
        hits.t[i] = first ? in : second ? out : infinite;
        hits.face[i] = first ? 1 : 0;
    }
    for (int i = 0; i < rays.count; ++i) {
        const double x = rays.x[i], y = rays.y[i], z = rays.z[i];
        const bool finite = x * 0 + y * 0 + z * 0 == 0;
        constexpr double smallest = std::numeric_limits<double>::min();
        const bool there =
            (std::abs(x) >= smallest) | (std::abs(y) >= smallest) | (std::abs(z) >= smallest);
        const bool sound = finite & there & (rays.t_min < rays.t_max[i]);
        hits.t[i] = sound ? hits.t[i] : infinite;
    }
}

void meet_plane(const Plane& plane, const ShapeRays& rays, ShapeHits& hits) {
    const ShapeDirections d(rays);
    const double x = rays.origin.x, y = rays.origin.y, z = rays.origin.z;
    const double height = plane.y, limit = plane.limit;
    Stretches at;
    for (int i = 0; i < rays.packet->count; ++i) {
        const double t = (height - y) / d.y[i];  // not finite where the ray runs along the plane
        const bool inside =
            (std::abs(x + t * d.x[i]) <= limit) & (std::abs(z + t * d.z[i]) <= limit);
        at.in[i] = at.out[i] = inside ? t : std::numeric_limits<double>::quiet_NaN();
    }
    keep_first(at, *rays.packet, hits);
    std::fill_n(hits.face, rays.packet->count, 0u);
}

void meet_sphere(const Sphere& sphere, const ShapeRays& rays, ShapeHits& hits) {
    const ShapeDirections d(rays);
    const double r = sphere.radius;
    const double x = rays.origin.x - sphere.centre.x, y = rays.origin.y - sphere.centre.y,
                 z = rays.origin.z - sphere.centre.z;
    const double distance = std::sqrt(x * x + y * y + z * z);
    const double product = (distance - r) * (distance + r);
    Stretches at;
    for (int i = 0; i < rays.packet->count; ++i) {
        const double a = d.x[i] * d.x[i] + d.y[i] * d.y[i] + d.z[i] * d.z[i];
        const double half_b = -(x * d.x[i] + y * d.y[i] + z * d.z[i]);
        const double s = half_b / a;
        const double px = x + s * d.x[i], py = y + s * d.y[i], pz = z + s * d.z[i];
        const double discriminant = r * r - (px * px + py * py + pz * pz);
        const double q = half_b + std::copysign(std::sqrt(a * discriminant), half_b);
        const double one = q / a, other = product / q;  // q = 0: other is not finite, nor taken
        const bool met = discriminant >= 0;
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        at.in[i] = met ? (other < one ? other : one) : none;
        at.out[i] = met ? (one < other ? other : one) : none;
    }
    keep_first(at, *rays.packet, hits);
    std::fill_n(hits.face, rays.packet->count, 0u);
}

void meet_cube(const Cube& cube, const ShapeRays& rays, ShapeHits& hits) {
    const ShapeDirections d(rays);
    const int count = rays.packet->count;
    Stretches at;
    alignas(64) Column in_face, out_face;
    for (int i = 0; i < count; ++i) {
        at.in[i] = -infinite;
        at.out[i] = infinite;
        in_face[i] = out_face[i] = 0;
    }
    const Column* const directions[3] = {&d.x, &d.y, &d.z};
    for (int axis = 0; axis < 3; ++axis) {
        const Column& direction = *directions[axis];
        const double lo = cube.centre[axis] - cube.side / 2 - rays.origin[axis];
        const double hi = cube.centre[axis] + cube.side / 2 - rays.origin[axis];
        const double low_face = 2.0 * axis, high_face = low_face + 1;
        for (int i = 0; i < count; ++i) {
            const bool negative = std::copysign(1.0, direction[i]) < 0;
            const double inverse = 1 / direction[i];
            const double near = (negative ? hi : lo) * inverse,
                         far = (negative ? lo : hi) * inverse;
            const bool later = near > at.in[i], sooner = far < at.out[i];
            in_face[i] = later ? (negative ? high_face : low_face) : in_face[i];
            out_face[i] = sooner ? (negative ? low_face : high_face) : out_face[i];
            at.in[i] = later ? near : at.in[i];
            at.out[i] = sooner ? far : at.out[i];
        }
    }
    for (int i = 0; i < count; ++i) {
        const bool met = at.in[i] <= at.out[i];
        at.in[i] = met ? at.in[i] : std::numeric_limits<double>::quiet_NaN();
        at.out[i] = met ? at.out[i] : std::numeric_limits<double>::quiet_NaN();
    }
    keep_first(at, *rays.packet, hits);
    for (int i = 0; i < count; ++i) {
        hits.face[i] = static_cast<std::uint32_t>(hits.face[i] != 0 ? in_face[i] : out_face[i]);
    }
}

}  // namespace
}  // namespace luch::wide
