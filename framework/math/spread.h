#pragma once

#include "framework/math/rng.h"

#include <cstdint>

namespace luch {

/// The index-th point of a sequence in [0, 1)² whose every beginning is spread evenly: the first
/// two dimensions of Sobol's sequence, a (0, 2)-sequence in base 2 (among the first 2^m points,
/// each elementary box of area 2^−m holds one), in an order and with digits scrambled by the key
/// (Owen scrambling by hashing: Burley, "Practical Hash-based Owen Scrambling", 2020). Every single
/// point is uniform, so a mean over any number of them has no bias. Sequences of different keys
/// have nothing to do with one another: the k-th points of two may be used together.
[[nodiscard]] Vec2d spread(Key key, std::uint32_t index);

/// The area-preserving map of the unit square to the unit disc that keeps neighbours together
/// (Shirley and Chiu, "A Low Distortion Map Between Disk and Square", 1997).
[[nodiscard]] Vec2d disc_of(const Vec2d& square);

}  // namespace luch
