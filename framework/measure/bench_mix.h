#pragma once

#include "framework/accel/isa.h"
#include "framework/math/size.h"

#include <string>
#include <vector>

namespace luch {

/// What `luch bench mix` is asked for.
struct MixBench {
    Size size{1920, 1080};
    int rounds = 7;  ///< how often each representation is mixed, in turn with the others
    Isa isa = Isa::plain;
};

/// How fast two pictures in one representation become their mean.
struct MixSpeed {
    /// "float" (RGB), "bytes" (one of RGBA after the other), "word" and "long" (four and eight
    /// channels in an integer, SWAR); those without "alone" in vectors of the compiler's.
    std::string mode;
    int bytes_per_pixel = 0;  ///< read and written
    double frame_ns = 0;      ///< a pixel, over whole frames
    double tile_ns = 0;       ///< a pixel, over a tile that stays in the cache
    /// The largest distance of a channel from its exact mean, in 255ths.
    double worst_error = 0;
};

/// Races the representations on one thread. "float" comes first.
std::vector<MixSpeed> raced(const MixBench& bench);

}  // namespace luch
