#pragma once

#include "framework/grading/homework.h"
#include "homework/ldr/check/samples.h"

#include <span>
#include <string_view>

namespace luch::homework::ldr {

/// Words as good as the reference's: at least 99.9 % of the channels within one level, at most
/// 0.05 % more than eight off, and the mean of the signed differences at most 0.1 level, which a
/// truncation is not. `where`: the size of the picture, for naming pixels.
grading::Finding same_words(std::span<const Word> yours, std::span<const Word> reference,
                            Size where = sample_size);

/// Words that must be these, bit for bit.
grading::Finding exactly(std::span<const Word> yours, std::span<const Word> expected,
                         std::string_view what);

/// Sums within a share of a level.
grading::Finding same_sums(std::span<const Wide> yours, std::span<const Wide> reference);

}  // namespace luch::homework::ldr
