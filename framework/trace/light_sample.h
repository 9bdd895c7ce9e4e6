#pragma once

#include "framework/math/rng.h"
#include "framework/scene/light.h"
#include "framework/trace/surface.h"

namespace luch {

/// A point that a light shines from, as the classic tracer uses it: what it sends to a surface
/// point when nothing is between.
struct LightSample {
    Vec3d to_light;  ///< unit length
    Ray shadow;      ///< what blocks it, blocks the light
    Rgb irradiance;  ///< on a surface that faces it; divided by the number of samples
    Rgb highlight;   ///< the light's colour, for Phong; divided by the number of samples
};

/// How many samples the classic tracer takes of a light.
int sample_count(const Light& light);

/// Whether all of its shadow rays start from one point, whatever the random numbers.
[[nodiscard]] bool stands_in_one_place(const Light& light);

/// Whether a surface stays dark whatever is in between: it faces away, or nothing is sent to it.
[[nodiscard]] inline bool is_dark(const LightSample& sample, const Surface& surface) {
    return !(glm::dot(surface.normal, sample.to_light) > 0) ||
           (sample.irradiance == Rgb(0) && sample.highlight == Rgb(0));
}

/// One of them: 0 ≤ index < sample_count(). A RectLight is cut into cells, with one jittered point
/// in each.
LightSample sample_of(const Light& light, int index, Key key, const Surface& surface);

}  // namespace luch
