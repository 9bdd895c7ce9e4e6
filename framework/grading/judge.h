#pragma once

#include "framework/grading/homework.h"

#include <span>
#include <string_view>

namespace luch::grading {

enum class Status { pass, fail, not_written, crashed, timed_out };
std::string_view to_string(Status status);

/// What came of one case of a test.
struct CaseResult {
    Status status = Status::pass;
    Finding finding;  ///< its pictures are in files by now
    std::vector<std::string> pictures;
};

/// What came of a test.
struct TestResult {
    std::string id;
    double points = 0, max_points = 0;
    double seconds = 0;
    std::vector<std::string> case_names{};
    std::vector<CaseResult> cases{};

    /// pass when all cases passed, else that of the first case that did not.
    [[nodiscard]] Status status() const;
    /// Index of the first case that did not pass; cases.size() when all did.
    [[nodiscard]] std::size_t first_failure() const;
    /// How many cases did not pass.
    [[nodiscard]] std::size_t failures() const;
};

struct JudgeOptions {
    double limit_s = 5;              ///< for a test, and again for each case by itself
    std::filesystem::path pictures;  ///< folder for pictures of failures; empty: none
};

/// Runs a test on a table of steps in another process. Where that does not come to its end, each
/// case gets one of its own, so that a crash or a loop takes no points from the others.
TestResult judge(const Test& test, const std::any& steps, const JudgeOptions& options);

/// How alike the failures of the same tests are, 0..1: of the wrong elements in either, how many
/// are wrong in both, in the same way (the Jaccard index of the signatures).
double likeness(std::span<const TestResult> some, std::span<const TestResult> others);

/// From this on, failures are said to have the same cause.
inline constexpr double alike = 0.5;

}  // namespace luch::grading
