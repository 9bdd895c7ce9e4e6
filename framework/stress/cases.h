#pragma once

#include "framework/technique/catalogue.h"

#include <string_view>
#include <vector>

// The table of extreme cases: scales that differ by many orders, parameters next to where formulas
// break down, input that nobody should send.
namespace luch::stress {

/// The rows about the core: rays, what they hit, the item buffer, transforms, the viewer's loop.
/// `full`: at the stated size, which takes many minutes; else a quick one.
std::vector<StressCase> core_cases(bool full);

/// The rows that a technique goes through, and its own. Its picture is held against truths known by
/// analysis, against its own other pictures, and against the baseline's for the record.
std::vector<StressCase> technique_cases(const TechniqueInfo& info, const TechniqueInfo& baseline,
                                        bool full);

/// Runs a case. What it throws is a failure.
StressResult result_of(const StressCase& stress_case);

/// "pass", "FAIL", "NOT WRITTEN", "does not apply".
std::string_view to_string(StressVerdict verdict);

}  // namespace luch::stress
