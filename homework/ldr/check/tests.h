#pragma once

#include "framework/grading/instructors.h"
#include "homework/ldr/check/samples.h"

// The tests of each task; every one asks only the step that it is about.
namespace luch::homework::ldr {

using Samples = grading::SharedSamples<Sample>;

grading::Task encode_task(const Samples& samples);
grading::Task add_task(const Samples& samples);
grading::Task modulate_task(const Samples& samples);
grading::Task mix_task(const Samples& samples);
grading::Task lerp_task(const Samples& samples);
grading::Task accumulate_task(const Samples& samples);
grading::Task resolve_task(const Samples& samples);

using SampleTest = grading::Finding (*)(const Steps& steps, const Sample& sample);

/// What a step does beside giving the reference's words: properties.cpp.
grading::Finding counts_misfits(const Steps& steps, const Sample& sample);
grading::Finding black_adds_nothing(const Steps& steps, const Sample& sample);
grading::Finding no_carry(const Steps& steps, const Sample& sample);
grading::Finding white_changes_nothing(const Steps& steps, const Sample& sample);
grading::Finding all_pairs(const Steps& steps, const Sample& sample);
grading::Finding half_of_the_same(const Steps& steps, const Sample& sample);
grading::Finding no_bias(const Steps& steps, const Sample& sample);
grading::Finding from_end_to_end(const Steps& steps, const Sample& sample);
grading::Finding sixty_four_layers(const Steps& steps, const Sample& sample);
grading::Finding many_are_as_one(const Steps& steps, const Sample& sample);

}  // namespace luch::homework::ldr
