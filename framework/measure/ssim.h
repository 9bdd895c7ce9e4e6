#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"
#include "framework/parallel/workers.h"

namespace luch {

/// Structural similarity, 1 for equal images, less where means, contrasts or structures differ.
/// Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment: From Error Visibility to Structural
/// Similarity, 2004, equation 13: windows of 11 × 11 pixels under a Gaussian of σ = 1.5, K1 = 0.01,
/// K2 = 0.03, L = 1.
struct SsimResult {
    Image<float> map;  ///< the mean of the three channels at each pixel; NaN where not finite
    /// Over the finite pixels whose window lies wholly inside. Along a side shorter than a window
    /// none does: there every pixel counts. NaN when no pixel counts.
    double mean = 0;
};

/// Each channel of the numbers as they are given, without a change of their encoding; windows
/// beyond the border see its mirror image. The same as scikit-image's structural_similarity with
/// gaussian_weights=True, use_sample_covariance=False, data_range=1. Pixels that are not finite are
/// replaced as finite_pair() says. Symmetric. Throws Error when the sizes differ.
SsimResult ssim(ImageView<const Rgb> reference, ImageView<const Rgb> image,
                const Workers& workers = Workers());

}  // namespace luch
