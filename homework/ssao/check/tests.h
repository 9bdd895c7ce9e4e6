#pragma once

#include "framework/grading/instructors.h"
#include "homework/ssao/check/samples.h"

// The tests of each task; every one asks only the step that it is about.
namespace luch::homework::ssao {

using Samples = grading::SharedSamples<Sample>;

grading::Task positions_task(const Samples& samples);
grading::Task normals_task(const Samples& samples);
grading::Task kernel_task(const Samples& samples);
grading::Task occlusion_task(const Samples& samples);
grading::Task blur_task(const Samples& samples);
grading::Task upsample_task(const Samples& samples);
grading::Task apply_task(const Samples& samples);

using SampleTest = grading::Finding (*)(const Steps& steps, const Sample& sample);

/// A case for every sample.
std::vector<grading::Case> cases_of(const Samples& samples, SampleTest test);

}  // namespace luch::homework::ssao
