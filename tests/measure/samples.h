#pragma once

#include "framework/measure/report.h"

#include <filesystem>
#include <string>

// What the tests of this folder share.
namespace luch::testing {

/// A report of one scene called `name`: a technique swept over three settings (the last exact), one
/// that does not apply, and the baseline by samples. No pictures.
LabReport sample_report(const std::string& name);

/// How often a piece of text occurs.
std::size_t occurrences(const std::string& text, const std::string& piece);

/// A folder of its own for a test, empty.
std::filesystem::path empty_folder(const std::string& name);

/// What a command printed (both streams) and its exit status.
struct Ran {
    int status = -1;
    std::string text;
};
Ran shell(const std::string& command);

}  // namespace luch::testing
