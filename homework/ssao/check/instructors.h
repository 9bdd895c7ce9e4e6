#pragma once

#include "framework/grading/checker.h"
#include "homework/ssao/check/tests.h"

#include <cstdint>
#include <vector>

namespace luch::homework::ssao {

/// The part of the checker that needs the reference steps. The students' kit has another source of
/// this, where all of it is empty.
struct Instructors {
    std::vector<grading::Other> mutants, variants;
    /// Samples that nobody has seen.
    std::vector<Sample> (*samples_from_seed)(std::uint64_t seed) = nullptr;
    /// See grading::Checker.
    decltype(grading::Checker::regenerate) regenerate = nullptr;
    decltype(grading::Checker::handout) handout = nullptr;
};
Instructors instructors();

}  // namespace luch::homework::ssao
