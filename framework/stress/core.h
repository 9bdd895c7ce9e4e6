#pragma once

#include "framework/technique/stress_case.h"

#include <vector>

// The cases of the table that no technique has a part in.
namespace luch::stress {

/// rows(), with the instructions that this processor has.
std::vector<StressCase> row_cases(bool full);

/// Row 11: what the loader says to transforms that flatten.
std::vector<StressCase> loader_cases();

/// Row 20: the viewer's own loop, in a window that nobody sees.
StressCase viewer_case(bool full);

}  // namespace luch::stress
