#pragma once

#include "framework/grading/instructors.h"
#include "homework/vista/check/samples.h"

// The tests of each task; every one asks only the step that it is about.
namespace luch::homework::vista {

using Samples = grading::SharedSamples<Sample>;

grading::Task lod_task(const LodSample& lod);
grading::Task tessellate_task(const Samples& samples);
grading::Task clip_task(const Samples& samples);
grading::Task sort_task(const Samples& samples);
grading::Task project_task(const Samples& samples);
grading::Task rasterise_task(const Samples& samples);
grading::Task look_up_task(const Samples& samples);

using SampleTest = grading::Finding (*)(const Steps& steps, const Sample& sample);

/// A case for every sample.
std::vector<grading::Case> cases_of(const Samples& samples, SampleTest test);

/// The table in a grading::Case's argument.
inline const Steps& steps_in(const std::any& steps) {
    return *std::any_cast<Steps>(&steps);
}

}  // namespace luch::homework::vista
