#pragma once

#include "framework/grading/report.h"

#include <functional>

namespace luch::grading {

struct CheckOptions {
    std::optional<std::uint64_t> seed;  ///< only said in the report: the homework has its cases
    std::filesystem::path json;         ///< rewritten after every test; empty: none
    JudgeOptions judge;
    /// Called before every test with the share of them that is done.
    std::function<void(double done, const std::string& test)> on_test;
    /// Called when all tests of a task are done.
    std::function<void(const Report& report, const Report::Task& task)> on_task;
};

/// Runs every test of a homework on the student's steps. A task whose hole was reached is "not
/// attempted"; for one that failed, the likely cause is looked up among the mutants.
Report check(const Homework& homework, const CheckOptions& options);

/// Mutants or variants against tests.
struct Matrix {
    std::vector<std::string> tests;
    struct Row {
        const Other* other = nullptr;
        std::vector<std::size_t> failures{};  ///< of each test: how many of its cases
        std::size_t cases_named = 0;          ///< distinct names of cases that failed
        std::string likely{};                 ///< a mutant: the name that its own failures lead to
        std::string first{};                  ///< the first failure in words
    };
    std::vector<Row> rows;
};

/// Tries every mutant on the tests of the task that it changes. Killed: on two scenes or more.
Matrix kill_matrix(const Homework& homework, const JudgeOptions& judge);
/// Tries every honest variant on the tests of the step that it changes (all, where it names none).
Matrix variant_matrix(const Homework& homework, const JudgeOptions& judge);

/// Whether every mutant died on two scenes and was named as what it is; every variant passed.
bool all_killed(const Matrix& matrix);
bool all_passed(const Matrix& matrix);

std::string matrix_text(const Matrix& matrix);

}  // namespace luch::grading
