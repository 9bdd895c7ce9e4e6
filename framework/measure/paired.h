#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

#include <cstdint>

namespace luch {

/// Two images of one size in which every pixel is finite, so that a filter over them spreads no
/// NaN.
struct FinitePair {
    Image<Rgb> reference, image;
    Image<std::uint8_t> kept;  ///< 0 where a pixel was replaced: its own error means nothing
    std::size_t count = 0;     ///< of kept pixels
};

/// A pixel that is not finite in one image is taken from the other in both, and is black in both
/// where neither is finite: between replaced pixels there is no difference that their neighbours
/// would see. Throws Error when the sizes differ.
FinitePair finite_pair(ImageView<const Rgb> reference, ImageView<const Rgb> image);

/// The mean of a map over the kept pixels, NaN when there are none; sets all others to NaN.
double mean_of_kept(const FinitePair& pair, Image<float>& map);

/// Throws Error that names both sizes when they differ.
void check_sizes(Size reference, Size image);

}  // namespace luch
