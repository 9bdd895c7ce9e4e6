#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"
#include "framework/technique/outcome.h"

namespace luch {

/// Temporal flicker of a sequence of frames: the mean of |(v_t − v_t₋₁) − (r_t − r_t₋₁)| over
/// frames, pixels and channels. An error that stands still does not count, a reference that moves
/// does not, either. It is the temporal loss tLP of Chu et al.: Learning Temporal Coherence via
/// Self-Supervision for GAN-based Video Generation, 2020, with plain differences in the place of
/// LPIPS.
class Flicker {
 public:
    /// The next frame and its reference. Pixels that are not finite, now or a frame before, are
    /// counted apart. Throws Error when a size differs from the other's or the last frame's.
    void add(ImageView<const Rgb> reference, ImageView<const Rgb> image);

    /// 0 for a sequence without any change in errors; NaN before the second frame, and where no
    /// pixel was finite in two frames in a row.
    [[nodiscard]] double mean() const;

    /// Pixels of all frames that are not finite; the first's place is that in its own frame.
    [[nodiscard]] const NonFinite& non_finite() const { return non_finite_; }

 private:
    Image<Vec3d> error_;  ///< v − r of the last frame
    double sum_ = 0;
    std::size_t channels_ = 0;
    NonFinite non_finite_;
};

}  // namespace luch
