#pragma once

#include "framework/grading/homework.h"
#include "techniques/ldr/ldr.h"

#include <vector>

// Solutions that the tests are tried on, made from the reference by changing one step.
namespace luch::homework::ldr {

/// Known mistakes of students (mutants/), which must fail.
std::vector<grading::Other> mutants();
/// Honest solutions (variants/), which must pass.
std::vector<grading::Other> variants();

/// The reference with one step exchanged: with(&Steps::add, my_add).
template <class Step>
techniques::ldr::Steps with(Step techniques::ldr::Steps::*which, Step step) {
    techniques::ldr::Steps steps = techniques::ldr::reference();
    steps.*which = step;
    return steps;
}

}  // namespace luch::homework::ldr
