#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

#include <array>

namespace luch {

/// Light from infinitely far, as six pictures on the sides of a cube, in linear light.
struct CubemapEnvironment {
    enum Side { neg_x, neg_y, neg_z, pos_x, pos_y, pos_z };
    std::array<Image<Rgb>, 6> sides;

    /// The radiance from a direction of any length.
    [[nodiscard]] Rgb radiance(const Vec3d& direction) const;
};

}  // namespace luch
