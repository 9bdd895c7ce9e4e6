#pragma once

#include "framework/grading/homework.h"
#include "techniques/vista/vista.h"

#include <vector>

// Solutions that the tests are tried on, made from the reference by changing one step.
namespace luch::homework::vista {

/// Known mistakes of students (mutants/), which must fail.
std::vector<grading::Other> mutants();
/// Honest solutions (variants/), which must pass.
std::vector<grading::Other> variants();

/// The reference with one step exchanged: with(&Steps::sort, my_sort).
template <class Step>
techniques::vista::Steps with(Step techniques::vista::Steps::*which, Step step) {
    techniques::vista::Steps steps = techniques::vista::reference();
    steps.*which = step;
    return steps;
}

}  // namespace luch::homework::vista
