#pragma once

#include "framework/grading/instructors.h"
#include "homework/layered/check/samples.h"

// The tests of each task; every one asks only the step that it is about.
namespace luch::homework::layered {

using Samples = grading::SharedSamples<Sample>;

grading::Task cut_task(const Samples& samples);
grading::Task coc_task(const Samples& samples);
grading::Task gaussian_task(const Samples& samples);
grading::Task disc_task(const Samples& samples);
grading::Task over_task(const Samples& samples);

using SampleTest = grading::Finding (*)(const Steps& steps, const Sample& sample);

/// A case for every sample.
std::vector<grading::Case> cases_of(const Samples& samples, SampleTest test);

}  // namespace luch::homework::layered
