#pragma once

#include "framework/grading/instructors.h"
#include "homework/ssao/check/samples.h"

namespace luch::homework::ssao {

/// The part of the checker that needs the reference steps. The students' kit has another source of
/// this, where all of it is empty.
grading::Instructors<Sample> instructors();

}  // namespace luch::homework::ssao
