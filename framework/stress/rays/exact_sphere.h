#pragma once

#include "framework/math/ray.h"
#include "framework/scene/geometry.h"

#include <cmath>

namespace luch::stress {

/// Where a ray meets a sphere, in long double.
struct ExactHit {
    long double t = 0;  ///< of the nearest hit with t_min < t < t_max
    bool hit = false;
    bool at_rim = false;  ///< so close to the rim that any answer is right in double
};

inline ExactHit exact_hit(const Sphere& sphere, const Ray& ray) {
    using T = long double;
    T to[3], d[3], a = 0, b = 0;
    for (int k = 0; k < 3; ++k) {
        to[k] = static_cast<T>(ray.origin[k]) - sphere.centre[k];
        d[k] = ray.direction[k];
        a += d[k] * d[k];
        b -= to[k] * d[k];
    }
    T off = 0, distance = 0;
    for (int k = 0; k < 3; ++k) {
        const T across = to[k] + b / a * d[k];
        off += across * across;
        distance += to[k] * to[k];
    }
    const T radius = sphere.radius, left = radius * radius - off;
    ExactHit result;
    result.at_rim = std::abs(left) < 1e-12L * (radius * radius + 1e-4L * distance);
    if (left < 0) return result;
    const T product = (std::sqrt(distance) - radius) * (std::sqrt(distance) + radius);
    const T q = b + std::copysign(std::sqrt(a * left), b);
    const T one = q / a, other = product / q;
    for (const T t : {std::max(one, other), std::min(one, other)}) {
        if (!(t > ray.t_min && t < ray.t_max)) continue;
        result.t = t;
        result.hit = true;
    }
    return result;
}

/// Whether a hit is the exact one, but for a relative error of t.
inline bool is_right(const ExactHit& exact, const Hit& hit, double tolerance) {
    if (exact.at_rim) return true;
    if (exact.hit != static_cast<bool>(hit)) return false;
    return !hit || std::abs(hit.t - exact.t) <= tolerance * exact.t;
}

}  // namespace luch::stress
