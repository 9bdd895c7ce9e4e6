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
    double limit_s = 10;            ///< for one case
    std::filesystem::path pictures; ///< folder for pictures of failures; empty: none
};

/// Runs a test on a table of steps, each case in a process of its own.
TestResult judge(const Test& test, const std::any& steps, const JudgeOptions& options);

/// The mistake whose failures look most like these: of those for which the same elements are wrong
/// in the same cases (the Jaccard index of the two sets is at least ½), the most similar. Null when
/// none is. `failed` are tests of one task with what came of them.
const Other* likely_mutant(std::span<const std::pair<const Test*, const TestResult*>> failed,
                           std::span<const Other> mutants, const std::string& task,
                           const JudgeOptions& options);

}  // namespace luch::grading
