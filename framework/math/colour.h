#pragma once

#include "framework/math/vec.h"

#include <cstdint>

namespace luch {

/// Linear light, red, green, blue; 1 is the display's white.
using Rgb = Vec3;

/// The sRGB curve (IEC 61966-2-1) for one channel; values outside 0..1 are clamped, NaN gives 0.
float srgb_encoded(float linear);
/// Its inverse, for 0..1.
float srgb_decoded(float encoded);
Rgb srgb_encoded(const Rgb& linear);
Rgb srgb_decoded(const Rgb& encoded);

/// A channel in 0..1 as 8 bits, rounded to nearest; what lies outside is clamped, NaN gives 0.
[[nodiscard]] inline std::uint8_t byte_of(float channel) {
    return static_cast<std::uint8_t>((channel > 0 ? std::min(channel, 1.0f) : 0.0f) * 255.0f +
                                     0.5f);
}

}  // namespace luch
