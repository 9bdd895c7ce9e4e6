#pragma once

#include "framework/grading/homework.h"
#include "homework/shadow_map/check/samples.h"

// What passes and what fails when an answer is held against the reference's: an honest solution
// that differs in rounding or order passes.
namespace luch::homework::shadow_map {

/// The homework's own table.
const Steps& steps_in(const std::any& steps);

/// Texel by texel: no input is so near a border that rounding could decide.
grading::Finding same_texels(std::span<const Texel> yours, std::span<const Texel> reference,
                             std::string_view of);

/// Shares, 0..1, of some of a sample's receivers: within 1e-4. With `pixels` there are pictures of
/// what the camera sees.
grading::Finding same_shares(std::span<const float> yours, std::span<const float> reference,
                             std::string_view of);
grading::Finding same_shares_seen(std::span<const float> yours, std::span<const float> reference,
                                  const Sample& sample);

/// Where both have a surface: grading::same_depths(). Nodes tell where edges are.
grading::Finding same_distances(const CubeMap& yours, const CubeMap& reference,
                                const Sample& sample);
/// Where nothing is: infinity there, and only there.
grading::Finding same_gaps(const CubeMap& yours, const CubeMap& reference);

}  // namespace luch::homework::shadow_map
