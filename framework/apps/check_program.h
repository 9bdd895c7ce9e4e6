#pragma once

#include "framework/apps/arguments.h"
#include "framework/grading/checker.h"

namespace luch {

/// The program that checks one homework: the verb `check`, without the building.
int run_check_program(int argc, char** argv, const grading::Checker& checker);

}  // namespace luch
