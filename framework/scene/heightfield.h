#pragma once

#include "framework/image/image.h"
#include "framework/math/vec.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace luch {

/// A surface y = h(x, z) over 0..W × 0..H, from a picture of W × H heights: row 0 lies at z = 0,
/// and past the last pixel the heights go on as they were. Between grid points it consists of
/// triangles, two a cell: k = 0 at the corner (x, z), k = 1 at (x+1, z+1); they meet along the
/// diagonal from (x+1, z) to (x, z+1).
class Heightfield {
 public:
    /// Takes heights of 1 × 1 pixel or more, finite, no side longer than 16,384.
    explicit Heightfield(Image<float> heights);

    /// Cells along x and along z.
    [[nodiscard]] int width() const { return heights_.width(); }
    [[nodiscard]] int height() const { return heights_.height(); }

    /// h at a grid point, 0 ≤ x ≤ W, 0 ≤ z ≤ H.
    [[nodiscard]] float at(int x, int z) const {
        return heights_(std::min(x, width() - 1), std::min(z, height() - 1));
    }

    /// normalise(−(h(x+1,z) − h), 1, −(h(x,z+1) − h)); the last row and column, and what lies past
    /// them, copy their neighbour.
    [[nodiscard]] Vec3d normal(int x, int z) const;

    /// A triangle's number, below 2³⁰.
    [[nodiscard]] std::uint32_t primitive(int x, int z, int k) const {
        return 2 * (static_cast<std::uint32_t>(z) * static_cast<std::uint32_t>(width()) +
                    static_cast<std::uint32_t>(x)) +
               static_cast<std::uint32_t>(k);
    }

    struct Triangle {
        int x, z, k;
    };
    [[nodiscard]] Triangle triangle(std::uint32_t primitive) const {
        const std::uint32_t cell = primitive / 2, across = static_cast<std::uint32_t>(width());
        return {static_cast<int>(cell % across), static_cast<int>(cell / across),
                static_cast<int>(primitive % 2)};
    }

    /// Least and greatest height.
    struct Range {
        float lo, hi;
    };
    /// The level whose one block holds every cell.
    [[nodiscard]] int top_level() const { return static_cast<int>(levels_.size()); }
    /// Of the block of 2^level × 2^level cells that holds a cell; no height of the surface over the
    /// block lies outside of it.
    [[nodiscard]] Range range(int level, int x, int z) const;

    [[nodiscard]] std::uint64_t bytes() const;

 private:
    Image<float> heights_;
    std::vector<Image<Range>> levels_;  ///< from level 1 on
};

/// The heights blurred by a gaussian of deviation `sigma` pixels, as the course's scenes mean it:
/// weights exp(−(x²+y²)/2σ²)/(2πσ²) at offsets −R+1..R−1 with R = round(3σ), at most 128, not
/// renormalised, and black outside the picture, so the edges sink. R < 1 changes nothing.
Image<float> blurred(const Image<float>& heights, double sigma);

}  // namespace luch
