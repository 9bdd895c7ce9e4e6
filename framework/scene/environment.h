#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

#include <array>
#include <variant>

namespace luch {

/// Light from infinitely far, as six pictures on the sides of a cube, in linear light.
struct CubemapEnvironment {
    enum Side { neg_x, neg_y, neg_z, pos_x, pos_y, pos_z };
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
