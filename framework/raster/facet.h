#pragma once

#include <cstdint>

// What the stages of the rasteriser hand on, and why they may trust it.
//
// A ray hits a triangle unless two of the signs of w_k = (a_i × a_j)·d are opposite (hit.h). With d
// replaced by the longer D(X, Y) of View, w_k is linear in X and Y. Its coefficients are found in
// double, counted from an anchor beside the triangle, divided by a bound, given the sign of
// (a0 × a1)·a2, so that a triangle ahead has positive values, and rounded to float. Errors, in
// u = 2⁻²⁴ and units of max|a_i| · max|a_j − a_i|, a_i the nearer end of the edge: 2 sum for the
// rounding of the ray's own direction; the value is a sum of parts none of which exceeds it by more
// than m Σ(|dx_i| + |dy_i|) · 2, m the number of pixels from the anchor in X or Y, each of them
// rounded 6 times: 24 m Σ(|dx_i| + |dy_i|). The bound is 3 sum + 26 m Σ(|dx_i| + |dy_i|), enough
// for edge_sign() to be certain as well. So a value above 1 is certainly inside its edge, one below
// −1 certainly outside; between, nobody knows (it is in doubt). Squares of pixels are judged by
// their corners, which may be 130 pixels further from the anchor than m, at least 10, allows: less
// than 16 bounds.
//
// What follows, exactly:
//  - opposite certain signs are a miss;
//  - a positive sign of all three is a hit if (a0 × a1)·a2 is certain, at the t of the plane;
//  - three negative ones are a miss then: t < 0, and the slab of the triangle's box ends below 0;
//  - whatever is hit is hit within the triangle's box: t is clamped to its slab.
// The inverse depth n·D / n·a0, n the normal, is off from that of the hit function by at most the
// share `rho`. With P the sizes of the products in n, R = Σ P_i max|a_i| / |n·a0|: the hit
// function's n·a0 is off by 10u R of itself, and so is its n·D, since |D_i| ≤ max|a_i| / t inside a
// triangle; the corners' own rounding moves what t is clamped to by u R. 26u R has room for their
// products. The evaluation adds 12u of the size of its parts.
namespace luch::raster {

/// Depths whose relative error is larger are of no use.
inline constexpr float most_rho = 1.0f / 16;

/// Beyond this, values at the corners of squares are certain.
inline constexpr float far_outside = 16;

/// Pixels x0 ≤ x ≤ x1, y0 ≤ y ≤ y1.
struct Span {
    std::int16_t x0, y0, x1, y1;
    [[nodiscard]] bool empty() const { return x1 < x0 || y1 < y0; }
};

enum class Kind : std::uint32_t {
    /// All corners well ahead of the eye and no sliver: at every pixel some sign is certain to be
    /// positive, outside of the span some other to be negative. A value below −1 is a miss.
    regular,
    crossing,  ///< some corners are behind the eye: a miss when signs are opposite, or all negative
    turned,    ///< the same, seen from the side that is culled: no sign is positive where it is hit
    doubtful,  ///< nothing is certain but opposite signs
};

/// A triangle as seen by a frame. Values are linear: [0] + X · [1] + Y · [2], X and Y counted from
/// pixel (x, y) of the frame.
struct alignas(64) Facet {
    float edge[3][3];  ///< in units of their bound
    float depth[3];    ///< inverse depth, of no meaning for doubtful and turned ones
    float rho;         ///< relative error of that
    /// What no inverse depth in doubt exceeds; where negative, its size is what it may exceed the
    /// value of `depth` by at pixels whose edge values are all ≥ −1, and nothing is known of
    /// others.
    float doubt;
    std::uint32_t item;
    Kind kind : 2;
    std::uint32_t x : 15, y : 15;
};

/// What draw() works through.
struct Entry {
    const Facet* facet;
    Span span;
};

/// Items are numbers of triangles, over all nodes; the highest bit says ambiguous.
inline constexpr std::uint32_t ambiguous_bit = 0x80000000u;
inline constexpr std::uint32_t no_item = 0x7fffffffu;

/// The frame is cut into bins of side 64, 16 tiles a bin, 16 cells a tile, 16 pixels a cell, each
/// of them in rows of four.
inline constexpr int bin_side = 64;
inline constexpr int cells_of_bin = 256;
inline constexpr int pixels_of_bin = 4096;

/// A cell while it is drawn.
struct alignas(64) Cell {
    float near[16];       ///< inverse depth that the nearest certain hit has at least
    float near_most[16];  ///< that it has at most
    float rival[16];      ///< that all the others have at most
    float item[16];       ///< the bits of the nearest one's
};

}  // namespace luch::raster
