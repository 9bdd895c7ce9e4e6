#pragma once

#include "framework/grading/homework.h"
#include "homework/ssao/check/samples.h"

// What passes and what fails when a plane is held against the reference's: an honest solution that
// differs in rounding or order passes.
namespace luch::homework::ssao {

/// Planes of one size: |yours − reference| ≤ 1e-4 · max(1, |reference|). Numbers that are not
/// finite must be the same, NaN for NaN.
grading::Finding same_plane(const Image<float>& yours, const Image<float>& reference,
                            std::string_view name);

/// The same for three numbers a pixel.
grading::Finding same_vectors(const Image<Vec3>& yours, const Image<Vec3>& reference,
                              std::string_view name);

/// One failure for all pixels that are marked in `wrong`, else none. `yours` is shown beside
/// `reference`.
grading::Finding unless_marked(const Image<std::uint8_t>& wrong, std::string_view what,
                               const Image<float>& yours, const Image<float>& reference);

}  // namespace luch::homework::ssao
