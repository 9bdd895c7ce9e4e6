#pragma once

#include "framework/grading/checker.h"
#include "homework/ldr/check/samples.h"

#include <cstdint>

// Needs the reference steps; the students' kit does without.
namespace luch::homework::ldr {

/// Samples that nobody has seen: pictures made from a seed.
std::vector<Sample> samples_from_seed(std::uint64_t seed, const Steps& steps);

/// Makes the public samples again and writes those files of homework/ldr/reference that change.
/// Returns how many differ.
int regenerate(const std::filesystem::path& root, const Steps& steps,
               const grading::Regeneration& regeneration);

}  // namespace luch::homework::ldr
