#pragma once

#include "framework/grading/homework.h"
#include "techniques/ssao/ssao.h"

#include <vector>

// Solutions that the tests are tried on, made from the reference by changing one step.
namespace luch::homework::ssao {

/// Known mistakes of students (mutants/), which must fail.
std::vector<grading::Other> mutants();
/// Honest solutions (variants/), which must pass.
std::vector<grading::Other> variants();

/// The reference with one step exchanged: with(&Steps::apply, my_apply).
template <class Step>
techniques::ssao::Steps with(Step techniques::ssao::Steps::*which, Step step) {
    techniques::ssao::Steps steps = techniques::ssao::reference();
    steps.*which = step;
    return steps;
}

}  // namespace luch::homework::ssao
