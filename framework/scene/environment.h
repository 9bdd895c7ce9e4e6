#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

#include <array>
#include <variant>

namespace luch {

/// Where a direction leaves a cube around the eye: the side, and s to the right and t down on it,
/// in −1..1.
struct CubePoint {
    enum Side { neg_x, neg_y, neg_z, pos_x, pos_y, pos_z };
    Side side = neg_x;
    double s = 0, t = 0;

    /// Towards it; the largest component is ±1.
    [[nodiscard]] Vec3d direction() const;
};

/// The largest component of a finite direction must not be 0. Ties go to x, then y.
CubePoint cube_point(const Vec3d& direction);

/// Light from infinitely far, as six pictures on the sides of a cube, in linear light.
struct CubemapEnvironment {
    using Side = CubePoint::Side;
    using enum CubePoint::Side;
    std::array<Image<Rgb>, 6> sides;

    /// The radiance from a direction of any length.
    [[nodiscard]] Rgb radiance(const Vec3d& direction) const;
};

/// The same light from everywhere.
struct ConstantEnvironment {
    Rgb color{1};

    [[nodiscard]] Rgb radiance(const Vec3d&) const { return color; }
};

using Environment = std::variant<ConstantEnvironment, CubemapEnvironment>;

}  // namespace luch
