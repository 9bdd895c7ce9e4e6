#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"
#include "framework/parallel/workers.h"

namespace luch {

// FLIP: how different two pictures look when an observer flips between them, from 0 (alike) to 1.
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: FLIP: A Difference Evaluator
// for Alternating Images, 2020; Andersson, Nilsson, Shirley, Akenine-Möller: Visualizing Errors in
// Rendered High Dynamic Range Images, 2021. Where the papers leave a detail open (the median, black
// references) the authors' implementation is followed, so that means agree with it.

/// A pixel's errors and their mean.
struct FlipResult {
    Image<float> map;  ///< 0..1; NaN where a pixel is not finite in either image
    double mean = 0;   ///< over the finite pixels, NaN when there are none
};

/// HDR-FLIP: at every pixel the largest LDR-FLIP over a row of exposures.
struct HdrFlipResult {
    FlipResult flip;
    Image<float> exposure;  ///< that the error of a pixel is at, in stops
    float start = 0;    ///< the first exposure, in stops: the brightest pixel is still told apart
    float stop = 0;     ///< the last: half of the pixels are no darker than that
    int exposures = 0;  ///< in equal steps from start to stop
};

/// An observer 0.7 m in front of a screen 0.7 m and 3840 pixels wide: 3840 · π/180.
inline constexpr double flip_pixels_per_degree = 67.02064327658226;

/// LDR-FLIP of two pictures as displayed (sRGB numbers, clamped to 0..1). A pixel that is not
/// finite in one of them is taken from the other in both (black if it is finite in neither), so
/// that no neighbour's error changes for it. Symmetric. Any number of workers gives the same
/// floats. Throws Error when the sizes differ.
FlipResult flip_ldr(ImageView<const Rgb> reference, ImageView<const Rgb> image,
                    const Workers& workers = Workers(),
                    double pixels_per_degree = flip_pixels_per_degree);

/// HDR-FLIP of two pictures in linear light, tone-mapped by Narkowicz's fit of ACES. The reference
/// decides about the exposures, so it is not symmetric. Pixels that are not finite are replaced as
/// above. Throws Error when the sizes differ.
HdrFlipResult flip_hdr(ImageView<const Rgb> reference, ImageView<const Rgb> image,
                       const Workers& workers = Workers(),
                       double pixels_per_degree = flip_pixels_per_degree);

}  // namespace luch
