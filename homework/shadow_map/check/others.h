#pragma once

#include "framework/grading/homework.h"
#include "techniques/shadow_map/shadow_map.h"

#include <vector>

// Solutions that the tests are tried on, made from the reference by changing one step.
namespace luch::homework::shadow_map {

/// Known mistakes of students (mutants/), which must fail.
std::vector<grading::Other> mutants();
/// Honest solutions (variants/), which must pass.
std::vector<grading::Other> variants();

/// The reference with one step exchanged: with(&Steps::lit, my_lit).
template <class Step>
techniques::shadow_map::Steps with(Step techniques::shadow_map::Steps::*which, Step step) {
    techniques::shadow_map::Steps steps = techniques::shadow_map::reference();
    steps.*which = step;
    return steps;
}

}  // namespace luch::homework::shadow_map
