#pragma once

#include "framework/grading/checker.h"
#include "homework/ssao/check/samples.h"

#include <cstdint>

// Needs the reference steps; the students' kit does without.
namespace luch::homework::ssao {

/// Runs the reference steps one after the other on a scene.
Sample sample_of(std::string name, std::shared_ptr<const Scene> scene, const Steps& steps);

/// Samples that nobody has seen: scenes made from a seed.
std::vector<Sample> samples_from_seed(std::uint64_t seed, const Steps& steps);

/// Makes the public samples again and writes those files of homework/ssao/reference that change.
/// Returns how many differ.
int regenerate(const std::filesystem::path& root, const Steps& steps,
               const grading::Regeneration& regeneration);

}  // namespace luch::homework::ssao
