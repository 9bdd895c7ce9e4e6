#pragma once

#include "framework/grading/homework.h"
#include "techniques/layered/layered.h"

#include <vector>

// Solutions that the tests are tried on, made from the reference by changing one step.
namespace luch::homework::layered {

/// Known mistakes of students (mutants/), which must fail.
std::vector<grading::Other> mutants();
/// Honest solutions (variants/), which must pass.
std::vector<grading::Other> variants();

/// The reference with one step exchanged: with(&Steps::over, my_over).
template <class Step>
techniques::layered::Steps with(Step techniques::layered::Steps::*which, Step step) {
    techniques::layered::Steps steps = techniques::layered::reference();
    steps.*which = step;
    return steps;
}

}  // namespace luch::homework::layered
