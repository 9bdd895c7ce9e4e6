#pragma once

#include "framework/grading/checker.h"
#include "homework/shadow_map/check/samples.h"

#include <cstdint>

// Needs the reference steps; the students' kit does without.
namespace luch::homework::shadow_map {

/// Runs the reference steps on a scene, with maps of n × n texels a face; the key decides on
/// directions and spots.
Sample sample_of(std::string name, std::shared_ptr<const Scene> scene, int n, Key key,
                 const Steps& steps);

/// Samples that nobody has seen: scenes made from a seed.
std::vector<Sample> samples_from_seed(std::uint64_t seed, const Steps& steps);

/// Makes the public samples again and writes those files of homework/shadow_map/reference that
/// change. Returns how many differ.
int regenerate(const std::filesystem::path& root, const Steps& steps,
               const grading::Regeneration& regeneration);

}  // namespace luch::homework::shadow_map
