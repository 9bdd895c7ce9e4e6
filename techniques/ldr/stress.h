#pragma once

#include "framework/technique/catalogue.h"

namespace luch::techniques::ldr {

/// What is extreme to words: light far above white, what is no number, many samples of one colour,
/// many lights of less than half a level.
std::vector<StressCase> stress_cases(const TechniqueInfo& info, bool full);

}  // namespace luch::techniques::ldr
