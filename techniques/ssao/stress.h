#pragma once

#include "framework/technique/catalogue.h"

#include <vector>

namespace luch::techniques::ssao {

/// Extreme cases of ambient occlusion: for `luch stress`, of the technique and of a homework.
std::vector<StressCase> stress_cases(const TechniqueInfo& info, bool full);

}  // namespace luch::techniques::ssao
