#pragma once

#include <cstdint>

namespace luch::assets {

/// Value noise on the unit square, after K. Perlin, An Image Synthesizer (1985): random values on a
/// lattice of columns × rows, joined by 6t⁵ − 15t⁴ + 10t³. It repeats at 1 in both directions, so a
/// picture of it tiles without a seam, and uses no library function, so it is the same everywhere.
class Noise {
 public:
    explicit Noise(std::uint64_t seed) : seed_(seed) {}

    /// In 0..1.
    [[nodiscard]] double at(double x, double y, int columns, int rows) const;

    /// `octaves` of at(), each twice as fine and half as strong as the one before; in 0..1.
    [[nodiscard]] double fractal(double x, double y, int columns, int rows, int octaves) const;

 private:
    std::uint64_t seed_;
};

}  // namespace luch::assets
