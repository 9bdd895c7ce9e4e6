#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

#include <array>
#include <vector>

namespace luch::flip {

/// The weights of all filters of FLIP for one viewing distance, each one-dimensional: a filter of
/// the plane is the product of two. Sizes are 2·radius + 1.
struct Kernels {
    using Weights = std::vector<float>;
    explicit Kernels(double pixels_per_degree);

    int contrast_radius = 0;  ///< of the contrast sensitivity functions, pixels
    Weights achromatic, red_green;
    Weights blue_yellow, blue_yellow_narrow;  ///< a sum of two products
    int feature_radius = 0;                   ///< of edge and point detection, pixels
    Weights smooth, edge, point;              ///< a Gaussian, its first and its second derivative

    [[nodiscard]] int radius() const { return std::max(contrast_radius, feature_radius); }
};

/// What the filters say about one row of an image, a value for each pixel.
struct FilteredRow {
    std::vector<Rgb> colour;         ///< linear RGB as the eye resolves it, clamped to 0..1
    std::vector<float> edge, point;  ///< strength of edges and of points, about 0..1
};

/// Some rows of an image, filtered: first along the rows, which are kept, then across. Pixels
/// beyond the border are those at it.
class Band {
 public:
    /// Of the rows y0 ≤ y < y1 of an image of linear light in 0..1.
    Band(const Kernels& kernels, ImageView<const Rgb> linear, int y0, int y1);

    /// One of these rows.
    [[nodiscard]] FilteredRow row(int y) const;

 private:
    // The planes that a row is filtered into; the names are those of Kernels.
    enum Plane { achromatic, red_green, blue_yellow, blue_yellow_narrow, smooth, edge, point };
    static constexpr int planes = 7;
    using Row = std::vector<float>;

    [[nodiscard]] std::array<Row, planes> filtered_along(ImageView<const Rgb> linear, int y) const;
    void add_across(Row& sum, Plane plane, const Kernels::Weights& weights, int y) const;
    [[nodiscard]] Row magnitude(Plane derivative, const Kernels::Weights& across, int y) const;

    const Kernels* kernels_;
    int first_ = 0;  ///< the image's row that rows_[0] is of
    int width_ = 0;
    std::vector<std::array<Row, planes>> rows_;  ///< with radius() more above and below
};

}  // namespace luch::flip
