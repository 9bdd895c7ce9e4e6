#pragma once

#include "framework/math/colour.h"
#include "framework/math/transform.h"

#include <variant>

namespace luch {

/// Light from a point: color · power / d².
struct PointLight {
    Vec3d position{0};
    Rgb color{1};
    float power = 1;
};

/// A unit square in its own xz plane, shining along its own −y; sampled on x_samples × y_samples
/// jittered cells. Its visible face is also a node of the scene, with an Emission material.
struct RectLight {
    Transform to_world;
    Rgb color{1};
    float power = 1;
    int x_samples = 3;
    int y_samples = 3;

    /// The unit normal of its lit side, in world space.
    [[nodiscard]] Vec3d facing() const;
};

/// A point light that shines into a cone only: in full up to `inner_cosine` from its direction,
/// not at all beyond `outer_cosine`, smoothly (3x² − 2x³ of the cosine) in between.
struct SpotLight {
    Vec3d position{0};
    Vec3d direction{0, -1, 0};  ///< unit length, away from the light
    double inner_cosine = 1;
    double outer_cosine = 0;
    Rgb color{1};
    float power = 1;

    /// The part of its light that it sends in a unit direction, 0..1.
    [[nodiscard]] double falloff(const Vec3d& away) const;
};

/// Light from infinitely far along one direction: color · power on a surface that faces it.
struct DirectionalLight {
    Vec3d direction{0, -1, 0};  ///< unit length, the way the light travels
    Rgb color{1};
    float power = 1;
};

using Light = std::variant<PointLight, RectLight, SpotLight, DirectionalLight>;

}  // namespace luch
