#pragma once

#include "framework/math/colour.h"

#include <cstdint>

namespace luch {

/// A pixel as a screen shows it: sRGB, 8 bits a channel, opaque.
struct Pixel {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    bool operator==(const Pixel&) const = default;
};

/// From channels that are sRGB already, 0..1.
[[nodiscard]] inline Pixel pixel_of(const Rgb& displayed) {
    return {byte_of(displayed.r), byte_of(displayed.g), byte_of(displayed.b)};
}

}  // namespace luch
