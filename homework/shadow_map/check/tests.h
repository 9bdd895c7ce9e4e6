#pragma once

#include "framework/grading/instructors.h"
#include "homework/shadow_map/check/samples.h"

// The tests of each task; every one asks only the step that it is about.
namespace luch::homework::shadow_map {

using Samples = grading::SharedSamples<Sample>;

grading::Task texel_task(const Samples& samples);
grading::Task direction_task(const Samples& samples);
grading::Task face_task(const Samples& samples);
grading::Task bias_task(const Samples& samples);
grading::Task lit_task(const Samples& samples);
grading::Task pcf_task(const Samples& samples);
grading::Task light_task(const Samples& samples);

using SampleTest = grading::Finding (*)(const Steps& steps, const Sample& sample);

/// A case for every sample.
std::vector<grading::Case> cases_of(const Samples& samples, SampleTest test);

}  // namespace luch::homework::shadow_map
