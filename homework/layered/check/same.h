#pragma once

#include "framework/grading/homework.h"
#include "homework/layered/check/samples.h"

// What passes and what fails when a layer is held against the reference's: an honest solution that
// differs in rounding or order passes.
namespace luch::homework::layered {

/// Layers of one size, channel by channel: |yours − reference| ≤ 1e-4 · max(1, |reference|).
/// Numbers that are not finite must be the same, NaN for NaN.
grading::Finding same_layers(const Image<Rgba>& yours, const Image<Rgba>& reference);

/// The same of one number a pixel.
grading::Finding same_plane(const Image<float>& yours, const Image<float>& reference,
                            std::string_view name);

}  // namespace luch::homework::layered
