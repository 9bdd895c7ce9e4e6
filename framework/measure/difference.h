#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

#include <filesystem>
#include <string>
#include <vector>

namespace luch {

/// |a − b| · factor in each channel, clamped to 0..1. Pixels that are not finite in either are
/// magenta. Throws Error when the sizes differ.
Image<Rgb> amplified_difference(ImageView<const Rgb> a, ImageView<const Rgb> b, double factor);

/// Each pixel's largest channel error as a colour of error_colour().
Image<Rgb> error_map(ImageView<const Rgb> a, ImageView<const Rgb> b);

/// The colour of an error, sRGB as displayed: black for none, then on a logarithmic scale from ½ of
/// 1/255 (dark blue) to 1 (white); magenta for NaN.
Rgb error_colour(double error);

/// A labelled place on the scale of error_colour(), 0 at its dark end and 1 at its bright one.
struct LegendTick {
    double position = 0;
    std::string label;  ///< the error in steps of 1/255
};
std::vector<LegendTick> error_legend();

/// The colour at a place of that scale.
Rgb legend_colour(double position);

/// Writes numbers that are sRGB already. (write_picture() takes linear light.) An .exr or .hdr gets
/// the numbers as they are.
void write_displayed(const std::filesystem::path& file, ImageView<const Rgb> displayed);

}  // namespace luch
