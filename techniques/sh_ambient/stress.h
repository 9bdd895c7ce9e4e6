#pragma once

#include "framework/technique/catalogue.h"

#include <vector>

namespace luch::techniques::sh_ambient {

/// Extreme cases of ambient light: for `luch stress`, of the technique and of a homework.
std::vector<StressCase> stress_cases(const TechniqueInfo& info, bool full);

}  // namespace luch::techniques::sh_ambient
