#pragma once

#include "framework/math/rng.h"
#include "framework/technique/technique.h"

namespace luch {

/// The key of a sample: all randomness of a pixel's sample but its place and its point of the lens
/// comes from it.
Key sample_key(const Shot& shot, int x, int y, int sample);

/// The samples a pixel that the classic tracer takes: Shot::spp, or with 0 (as the scene says) the
/// camera's lens samples where it has a lens, else one (the scene's anti-aliasing may add some).
int sample_count(const Shot& shot);

/// Where a sample of `samples` lies, in pixel coordinates: the centre when there is one, else
/// anywhere in the pixel, uniformly; the samples of a pixel are spread evenly.
Vec2d sample_position(const Shot& shot, int x, int y, int sample, int samples);

/// A sample's point of the lens's unit disc: uniform, spread evenly over a pixel's samples.
Vec2d lens_point(const Shot& shot, int x, int y, int sample);

/// A camera ray. `lens` false: through the middle of the lens, which is all that a pinhole has;
/// where the camera has no lens both are the same ray, bit for bit.
Ray primary_ray(const Screen& screen, const Shot& shot, int x, int y, int sample, int samples,
                bool lens);

}  // namespace luch
