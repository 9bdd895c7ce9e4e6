#pragma once

#include "homework/ldr/check/samples.h"

#include <functional>

// Needs the reference steps; the students' kit does without.
namespace luch::homework::ldr {

/// Samples that nobody has seen: pictures made from a seed.
std::vector<Sample> samples_from_seed(std::uint64_t seed, const Steps& steps);

/// Makes the public samples again and writes those files of homework/ldr/reference that change.
/// `say` gets a line for each; without `consent` nothing is written. Returns how many differ.
int regenerate(const std::filesystem::path& root, const Steps& steps, bool consent,
               const std::function<void(const std::string&)>& say);

}  // namespace luch::homework::ldr
