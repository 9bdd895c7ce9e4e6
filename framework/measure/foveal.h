#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"
#include "framework/measure/flip.h"
#include "framework/technique/technique.h"

namespace luch {

/// The finest detail that the eye resolves at an eccentricity, relative to where it looks:
/// e2/(e2 + e), e2 = 2.3°. Geisler and Perry: Real-Time Foveated Multiresolution System for
/// Low-Bandwidth Video Communication, 1998, equation 2 solved for the cut-off frequency.
double relative_acuity(double eccentricity_deg);

/// How far from the gaze a point of the screen is seen, in degrees; both in pixels. The screen is
/// flat and faced squarely at the gaze.
double eccentricity_deg(Vec2d point, const Gaze& gaze,
                        double pixels_per_degree = flip_pixels_per_degree);

/// √(Σ w (v − r)² / Σ w), w the squared relative acuity: what an observer who looks at the gaze can
/// still tell apart weighs most. The weights are those of FPSNR: Lee, Pattichis, Bovik: Foveated
/// Video Quality Assessment, 2002. Over the finite pixels; NaN when there are none. Throws Error
/// when the sizes differ.
double foveal_rmse(ImageView<const Rgb> reference, ImageView<const Rgb> image, const Gaze& gaze,
                   double pixels_per_degree = flip_pixels_per_degree);

}  // namespace luch
