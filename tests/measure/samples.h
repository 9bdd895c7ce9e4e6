#pragma once

#include "framework/measure/report.h"

#include <string>

// What the tests of this folder share.
namespace luch::testing {

/// A report of one scene called `name`: a technique swept over three settings (the last exact), one
/// that does not apply, and the baseline by samples. No pictures.
LabReport sample_report(const std::string& name);

/// How often a piece of text occurs.
std::size_t occurrences(const std::string& text, const std::string& piece);

}  // namespace luch::testing
