#pragma once

#include "framework/math/vec.h"

#include <limits>

namespace luch {

/// An axis-aligned box. The default is empty: it contains nothing and grows from the first point.
template <class V>
struct Bounds {
    using Scalar = typename V::value_type;
    V lo{std::numeric_limits<Scalar>::infinity()};
    V hi{-std::numeric_limits<Scalar>::infinity()};

    void grow(const V& point) {
        lo = glm::min(lo, point);
        hi = glm::max(hi, point);
    }
    void grow(const Bounds& other) {
        lo = glm::min(lo, other.lo);
        hi = glm::max(hi, other.hi);
    }
    [[nodiscard]] bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
    [[nodiscard]] V size() const { return hi - lo; }
    [[nodiscard]] V centre() const { return lo + (hi - lo) * Scalar(0.5); }
    /// Half of the surface area; 0 when empty.
    [[nodiscard]] Scalar half_area() const {
        if (empty()) return 0;
        const V s = size();
        return s.x * s.y + s.y * s.z + s.z * s.x;
    }
};

using Box = Bounds<Vec3>;
using Boxd = Bounds<Vec3d>;

}  // namespace luch
