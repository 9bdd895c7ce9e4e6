#include "framework/grading/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace luch::grading {
namespace {

/// What came of the tests of the task that it changes; of all where it says none.
struct Tried {
    std::vector<TestResult> results;
    Matrix::Row row;
};

void note(Tried& tried, const TestResult& result, std::set<std::string>& scenes) {
    tried.row.failures.back() = result.failures();
    for (std::size_t i = 0; i < result.cases.size(); ++i) {
        if (result.cases[i].status == Status::pass) continue;
        scenes.insert(result.case_names[i]);
        if (!tried.row.first.empty()) continue;
        tried.row.first = fmt::format("{} on {}: {}", result.id, result.case_names[i],
                                      result.cases[i].finding.what);
    }
}

Tried tried(const Homework& homework, const Other& other, const JudgeOptions& judge_options) {
    Tried tried{{}, {.other = &other}};
    std::set<std::string> scenes;
    for (const Task& task : homework.tasks) {
        for (const Test& test : task.tests) {
            tried.row.failures.push_back(0);
            if (!other.task.empty() && task.id != other.task) continue;
            tried.results.push_back(judge(test, other.steps, judge_options));
            note(tried, tried.results.back(), scenes);
        }
    }
    tried.row.cases_named = scenes.size();
    return tried;
}

/// Whose failures these are the most like; of equals the first.
std::string nearest(const Tried& one, const std::vector<Tried>& all) {
    std::string name;
    double most = 0;
    for (const Tried& each : all) {
        if (each.row.other->task != one.row.other->task) continue;
        const double like = likeness(one.results, each.results);
        if (like < alike || like <= most) continue;
        most = like;
        name = each.row.other->name;
    }
    return name;
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
    std::vector<Tried> all;
    for (const Other& mutant : homework.mutants) all.push_back(tried(homework, mutant, judge));
    Matrix matrix{test_names(homework), {}};
    for (Tried& each : all) {
        each.row.likely = nearest(each, all);
        matrix.rows.push_back(each.row);
    }
    return matrix;
}

Matrix variant_matrix(const Homework& homework, const JudgeOptions& judge) {
    Matrix matrix{test_names(homework), {}};
    for (const Other& variant : homework.variants) {
        matrix.rows.push_back(tried(homework, variant, judge).row);
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
