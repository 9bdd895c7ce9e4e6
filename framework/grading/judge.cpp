#include "framework/grading/judge.h"

#include "framework/grading/child.h"
#include "framework/grading/message.h"
#include "framework/image/io.h"
#include "framework/technique/todo.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace luch::grading {
namespace {

/// In the child.
CaseResult tried(const Case& each, const std::any& steps, const std::filesystem::path& folder) {
    CaseResult result;
    try {
        result.finding = each.run(steps);
    } catch (const NotWritten& hole) {
        return {Status::not_written, failure(hole.task() + " is still to be written"), {}};
    } catch (const std::exception& problem) {
        return {Status::crashed, failure(std::string("an exception: ") + problem.what()), {}};
    }
    if (result.finding.passed) return result;
    result.status = Status::fail;
    if (folder.empty()) return result;
    for (const NamedPicture& picture : result.finding.pictures) {
        const auto file = folder / (picture.name + ".png");
        write_picture(file, picture.pixels.view());
        result.pictures.push_back(file.string());
    }
    return result;
}

CaseResult judged(const Case& each, const std::any& steps, const std::filesystem::path& folder,
                  double limit_s) {
    const ChildEnd end =
        run_in_child([&] { return text_of(tried(each, steps, folder)); }, limit_s);
    if (end.how == ChildEnd::How::timed_out) {
        return {Status::timed_out,
                failure(fmt::format("not done after {:g} s: an endless loop?", limit_s)),
                {}};
    }
    if (end.how == ChildEnd::How::crashed) {
        return {Status::crashed, failure("crashed: " + end.text), {}};
    }
    return result_of(end.text);
}

/// How alike two signatures of one case are: elements in both, elements in either.
struct Likeness {
    std::size_t both = 0, either = 0;
    void add(const CaseResult& a, const CaseResult& b) {
        if (a.status == Status::pass && b.status == Status::pass) return;
        if (a.finding.wrong.empty() && b.finding.wrong.empty()) {
            // Nothing to count, but the same sort of end counts as one thing.
            both += a.status == b.status && a.finding.what == b.finding.what ? 1 : 0;
            ++either;
            return;
        }
        std::vector<std::uint32_t> shared;
        std::set_intersection(a.finding.wrong.begin(), a.finding.wrong.end(),
                              b.finding.wrong.begin(), b.finding.wrong.end(),
                              std::back_inserter(shared));
        both += shared.size();
        either += a.finding.wrong.size() + b.finding.wrong.size() - shared.size();
    }
    [[nodiscard]] double index() const {
        return either == 0 ? 0 : static_cast<double>(both) / static_cast<double>(either);
    }
};

}  // namespace

std::string_view to_string(Status status) {
    constexpr std::string_view words[] = {"pass", "fail", "not attempted", "crashed", "timed out"};
    return words[static_cast<std::size_t>(status)];
}

std::size_t TestResult::first_failure() const {
    const auto failed = std::find_if(cases.begin(), cases.end(), [](const CaseResult& each) {
        return each.status != Status::pass;
    });
    return static_cast<std::size_t>(failed - cases.begin());
}

std::size_t TestResult::failures() const {
    return static_cast<std::size_t>(std::count_if(
        cases.begin(), cases.end(),
        [](const CaseResult& each) { return each.status != Status::pass; }));
}

Status TestResult::status() const {
    const std::size_t first = first_failure();
    return first == cases.size() ? Status::pass : cases[first].status;
}

TestResult judge(const Test& test, const std::any& steps, const JudgeOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    TestResult result{.id = test.id, .max_points = test.points};
    for (const Case& each : test.cases) {
        // Pictures are made of the first failure, which is the one that is shown.
        const bool pictured = !options.pictures.empty() && result.failures() == 0;
        const auto folder = pictured ? options.pictures / test.id : std::filesystem::path();
        result.case_names.push_back(each.name);
        result.cases.push_back(judged(each, steps, folder, options.limit_s));
        // A second wait would tell nothing new.
        if (result.cases.back().status != Status::timed_out) continue;
        while (result.cases.size() < test.cases.size()) {
            result.case_names.push_back(test.cases[result.cases.size()].name);
            result.cases.push_back({Status::timed_out, failure("not tried"), {}});
        }
        break;
    }
    const double passed = static_cast<double>(result.cases.size() - result.failures());
    result.points = test.points * passed / static_cast<double>(result.cases.size());
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

const Other* likely_mutant(std::span<const std::pair<const Test*, const TestResult*>> failed,
                           std::span<const Other> mutants, const std::string& task,
                           const JudgeOptions& options) {
    const JudgeOptions quiet{options.limit_s, {}};
    const Other* best = nullptr;
    double most = 0.5;
    for (const Other& mutant : mutants) {
        if (mutant.task != task) continue;
        Likeness likeness;
        for (const auto& [test, result] : failed) {
            const TestResult theirs = judge(*test, mutant.steps, quiet);
            for (std::size_t i = 0; i < theirs.cases.size(); ++i) {
                likeness.add(result->cases[i], theirs.cases[i]);
            }
        }
        if (likeness.index() < most) continue;
        best = &mutant;
        most = likeness.index();
    }
    return best;
}

}  // namespace luch::grading
