#include "framework/grading/check.h"

namespace luch::grading {
namespace {

/// For what is left of a task after one of its tests did not end in time.
constexpr double hurried_s = 1;

/// The mutant whose failures are the most like these, if any is enough.
std::string likely_cause(const Homework& homework, const Task& task, const Report::Task& result,
                         const JudgeOptions& options) {
    const JudgeOptions quiet{options.limit_s, {}};
    std::vector<TestResult> failed;
    std::vector<const Test*> tests;
    for (std::size_t i = 0; i < task.tests.size(); ++i) {
        if (result.tests[i].status() != Status::fail) continue;
        failed.push_back(result.tests[i]);
        tests.push_back(&task.tests[i]);
    }
    std::string cause;
    double most = alike;
    for (const Other& mutant : homework.mutants) {
        if (failed.empty() || mutant.task != task.id) continue;
        std::vector<TestResult> theirs;
        for (const Test* test : tests) theirs.push_back(judge(*test, mutant.steps, quiet));
        const double likeness_of_this = likeness(failed, theirs);
        if (likeness_of_this < most) continue;
        most = likeness_of_this;
        cause = mutant.cause;
    }
    return cause;
}

std::string scene_of_failure(const Test& test, const TestResult& result) {
    const std::size_t which = result.first_failure();
    return which == test.cases.size() ? "" : test.cases[which].scene;
}

}  // namespace

Report check(const Homework& homework, const CheckOptions& options) {
    Report report{.topic = homework.topic, .readme = homework.readme, .seed = options.seed};
    // All tasks stand in the report from the first test on, with their points.
    std::size_t count = 0, done = 0;
    for (const Task& task : homework.tasks) {
        report.tasks.push_back({.id = task.id, .title = task.title, .max_points = points_of(task)});
        count += task.tests.size();
    }
    for (std::size_t i = 0; i < homework.tasks.size(); ++i) {
        const Task& task = homework.tasks[i];
        Report::Task& result = report.tasks[i];
        JudgeOptions judge_options = options.judge;
        for (const Test& test : task.tests) {
            if (options.on_test) {
                options.on_test(static_cast<double>(done++) / static_cast<double>(count), test.id);
            }
            result.tests.push_back(judge(test, homework.yours, judge_options));
            if (result.tests.back().status() == Status::timed_out)
                judge_options.limit_s = hurried_s;
            result.scenes.push_back(scene_of_failure(test, result.tests.back()));
            if (!options.json.empty()) write_report_json(report, options.json);
        }
        result.likely = likely_cause(homework, task, result, options.judge);
        if (options.on_task) options.on_task(report, result);
    }
    report.complete = true;
    if (!options.json.empty()) write_report_json(report, options.json);
    return report;
}

}  // namespace luch::grading
