#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

namespace luch {

/// The colour map "magma", sRGB as displayed: black for 0, through violet and orange, to a light
/// yellow for 1; brightness rises evenly. Rounded to the nearest of its 256 colours; what lies
/// outside is clamped. (Van der Walt and Smith, in matplotlib since 2015, CC0.)
Rgb magma(float value);

/// Every pixel as a colour of magma(); green for NaN, which the map does not hold.
Image<Rgb> in_magma(ImageView<const float> values);

}  // namespace luch
