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

/// How fast colours in one representation are worked on.
struct MixSpeed {
    /// Two pictures become their mean: "float" (RGB), "bytes" (one of RGBA after the other), "word"
    /// and "long" (four and eight channels in an integer, SWAR); those without "alone" in vectors
    /// of the compiler's; "in place" the mean replaces one of them. "planes": a frame is put
    /// together from six. "texture": bilinear look-ups.
    std::string mode;
    std::string against;         ///< the mode of floats that it is to be held against
    double bytes_per_pixel = 0;  ///< read and written
    int tile_side = 64;          ///< pixels of a tile that stays in the cache
    double frame_ns = 0;  ///< a pixel, over whole frames, others having been worked on before
    double again_ns = 0;  ///< the same at once once more: what the caches kept helps
    double tile_ns = 0;   ///< a pixel, over a tile
    /// The largest distance of a channel from its exact value, in 255ths.
    double worst_error = 0;
};

/// Races the representations on one thread. Modes of floats come before those held against them.
std::vector<MixSpeed> raced(const MixBench& bench);

}  // namespace luch
