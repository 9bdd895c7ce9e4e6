#include "framework/grading/report.h"

#include "framework/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luch::grading {
namespace {

/// "out/x/{yours,reference}.png" of files in one folder.
std::string braced(const std::vector<std::string>& files) {
    std::vector<std::string> stems;
    for (const std::string& file : files) stems.push_back(std::filesystem::path(file).stem());
    const std::filesystem::path first = files.front();
    if (files.size() == 1) return first.string();
    return fmt::format("{}/{{{}}}{}", first.parent_path().string(), fmt::join(stems, ","),
                       first.extension().string());
}

std::string_view verdict_word(Status status) {
    switch (status) {
        case Status::pass:
            return "PASS";
        case Status::not_written:
            return "NOT ATTEMPTED";
        case Status::crashed:
            return "CRASH";
        case Status::timed_out:
            return "TIMEOUT";
        case Status::fail:
            break;
    }
    return "FAIL";
}

std::string score(double points, double most) {
    return points_text(points) + "/" + points_text(most);
}

std::string failure_text(const Report& report, const Report::Task& task, std::size_t index) {
    const TestResult& test = task.tests[index];
    const std::size_t which = test.first_failure();
    const CaseResult& shown = test.cases[which];
    std::string text = fmt::format("  {}\n", shown.finding.what);
    if (!shown.finding.first.empty()) text += fmt::format("  first: {}\n", shown.finding.first);
    if (!task.likely.empty()) {
        text +=
            fmt::format("  likely: {} — {}{}\n", task.likely, report.readme, anchor_of(task.id));
    }
    if (!shown.pictures.empty()) text += fmt::format("  images: {}\n", braced(shown.pictures));
    text += fmt::format("  replay: {}\n", replay_command(report, task, index));
    return text;
}

}  // namespace

double Report::Task::points() const {
    double sum = 0;
    for (const TestResult& test : tests) sum += test.points;
    return sum;
}

Status Report::Task::status() const {
    const auto is = [](Status status) {
        return [status](const TestResult& test) { return test.status() == status; };
    };
    if (points() <= 0 && std::any_of(tests.begin(), tests.end(), is(Status::not_written))) {
        return Status::not_written;
    }
    const auto bad = std::find_if_not(tests.begin(), tests.end(), is(Status::pass));
    return bad == tests.end() ? Status::pass : bad->status();
}

double Report::points() const {
    double sum = 0;
    for (const Task& task : tasks) sum += task.points();
    return sum;
}

double Report::max_points() const {
    double sum = 0;
    for (const Task& task : tasks) sum += task.max_points;
    return sum;
}

std::string points_text(double points) {
    return fmt::format("{:g}", std::round(points * 10) / 10);
}

std::string anchor_of(const std::string& task_id) {
    return "#" + task_id.substr(task_id.rfind('.') + 1);
}

std::string replay_command(const Report& report, const Report::Task& task, std::size_t test) {
    const TestResult& result = task.tests[test];
    const std::size_t which = result.first_failure();
    const std::string& scene = task.scenes[test];
    const std::string pixel =
        which < result.cases.size() ? result.cases[which].finding.pixel : std::string();
    if (scene.empty() || pixel.empty()) {
        const std::string seed = report.seed ? fmt::format(" --seed {}", *report.seed) : "";
        return fmt::format("luch check {} --task {}{}", report.topic, result.id, seed);
    }
    return fmt::format("luch view {} -t homework/{} --pixel {}", scene, report.topic, pixel);
}

std::string task_text(const Report& report, const Report::Task& task) {
    if (task.status() == Status::not_written) {
        return fmt::format("NOT ATTEMPTED {}  0/{}  {} — {}{}\n", task.id,
                           points_text(task.max_points), task.title, report.readme,
                           anchor_of(task.id));
    }
    std::string text;
    for (std::size_t i = 0; i < task.tests.size(); ++i) {
        const TestResult& test = task.tests[i];
        text += fmt::format("{} {}  {}\n", verdict_word(test.status()), test.id,
                            score(test.points, test.max_points));
        if (test.status() != Status::pass) text += failure_text(report, task, i);
    }
    return text;
}

std::string sum_text(const Report& report) {
    std::vector<std::string> holes;
    for (const Report::Task& task : report.tasks) {
        if (task.status() == Status::not_written) holes.push_back(task.id);
    }
    const std::string rest =
        holes.empty() ? "" : fmt::format("; not attempted: {}", fmt::join(holes, ", "));
    return fmt::format("{} of {} points{}\n", points_text(report.points()),
                       points_text(report.max_points()), rest);
}

}  // namespace luch::grading
