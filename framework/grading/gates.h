#pragma once

#include "framework/grading/homework.h"

#include <span>
#include <string_view>

// What passes and what fails when a step's output is held against the reference's on the same
// input: an honest solution that differs in rounding or order passes, a wrong one fails. Pictures
// compared here must be of one size.
namespace luch::grading {

/// Ids (nodes, triangles; all bits set: none): at most 0.05 % of the pixels differ, all of them
/// within 1 px of an edge between two ids of the reference.
Finding same_ids(ImageView<const std::uint32_t> yours, ImageView<const std::uint32_t> reference,
                 std::string_view thing = "id");

/// Depths, only where the ids of both are the same and the reference's is finite: of the relative
/// errors the 99th percentile is at most 1e-4 and, off the edges of `ids`, the largest 1e-3. A
/// number that is not finite, or not positive, where the reference is, is wrong.
Finding same_depths(ImageView<const float> yours, ImageView<const float> reference,
                    ImageView<const std::uint32_t> your_ids,
                    ImageView<const std::uint32_t> reference_ids);

/// Numbers in a list: |yours − reference| ≤ tolerance · max(1, |reference|) for all; `name` says
/// what they are ("the x of corner"), `per` how many belong to one element.
Finding same_numbers(std::span<const double> yours, std::span<const double> reference,
                     double tolerance, std::string_view name, std::size_t per = 1);

/// The first of some findings that did not pass, else one that did.
Finding first_failure_of(std::vector<Finding> findings);

/// Ids in colours that are easy to tell apart; none is black.
Image<Rgb> id_colours(ImageView<const std::uint32_t> ids);
/// Near is bright; infinity is black.
Image<Rgb> depth_greys(ImageView<const float> depths);

}  // namespace luch::grading
