#include "framework/grading/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace luch::grading {
namespace {

Matrix::Row row_of(const Homework& homework, const Other& other, const std::string& only_task,
                   const JudgeOptions& judge_options) {
    Matrix::Row row{.other = &other};
    std::set<std::string> scenes;
    std::vector<TestResult> results;
    std::vector<const Test*> tests;
    for (const Task& task : homework.tasks) {
        for (const Test& test : task.tests) {
            row.failures.push_back(0);
            if (!only_task.empty() && task.id != only_task) continue;
            results.push_back(judge(test, other.steps, judge_options));
            tests.push_back(&test);
            row.failures.back() = results.back().failures();
            for (std::size_t i = 0; i < results.back().cases.size(); ++i) {
                const CaseResult& each = results.back().cases[i];
                if (each.status == Status::pass) continue;
                scenes.insert(results.back().case_names[i]);
                if (row.first.empty()) {
                    row.first = fmt::format("{} on {}: {}", test.id, results.back().case_names[i],
                                            each.finding.what);
                }
            }
        }
    }
    row.cases_named = scenes.size();
    std::vector<std::pair<const Test*, const TestResult*>> failed;
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i].status() != Status::pass) failed.emplace_back(tests[i], &results[i]);
    }
    if (failed.empty() || only_task.empty()) return row;
    const Other* likely = likely_mutant(failed, homework.mutants, only_task, judge_options);
    if (likely != nullptr) row.likely = likely->name;
    return row;
}

std::vector<std::string> test_names(const Homework& homework) {
    std::vector<std::string> names;
    for (const Task& task : homework.tasks) {
        for (const Test& test : task.tests) names.push_back(test.id);
    }
    return names;
}

bool killed(const Matrix::Row& row) {
    return row.cases_named >= 2;
}

}  // namespace

Matrix kill_matrix(const Homework& homework, const JudgeOptions& judge) {
    Matrix matrix{test_names(homework), {}};
    for (const Other& mutant : homework.mutants) {
        matrix.rows.push_back(row_of(homework, mutant, mutant.task, judge));
    }
    return matrix;
}

Matrix variant_matrix(const Homework& homework, const JudgeOptions& judge) {
    Matrix matrix{test_names(homework), {}};
    for (const Other& variant : homework.variants) {
        matrix.rows.push_back(row_of(homework, variant, "", judge));
    }
    return matrix;
}

bool all_killed(const Matrix& matrix) {
    return std::all_of(matrix.rows.begin(), matrix.rows.end(), [](const Matrix::Row& row) {
        return killed(row) && row.likely == row.other->name;
    });
}

bool all_passed(const Matrix& matrix) {
    return std::all_of(matrix.rows.begin(), matrix.rows.end(),
                       [](const Matrix::Row& row) { return row.cases_named == 0; });
}

std::string matrix_text(const Matrix& matrix) {
    std::string text;
    for (const Matrix::Row& row : matrix.rows) {
        text += fmt::format("{:<28} {:<9} fails on {} scenes  {}\n", row.other->name,
                            row.other->task, row.cases_named, row.other->cause);
        for (std::size_t i = 0; i < row.failures.size(); ++i) {
            if (row.failures[i] == 0) continue;
            text += fmt::format("    {:<40} {} cases\n", matrix.tests[i], row.failures[i]);
        }
        if (!row.first.empty()) text += fmt::format("    {}\n", row.first);
        if (row.cases_named > 0 && !row.likely.empty()) {
            text += fmt::format("    taken for: {}\n", row.likely);
        }
    }
    return text;
}

}  // namespace luch::grading
