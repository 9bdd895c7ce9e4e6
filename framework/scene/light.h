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
};

using Light = std::variant<PointLight, RectLight>;

}  // namespace luch
