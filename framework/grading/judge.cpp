#include "framework/grading/judge.h"

#include "framework/base/text.h"
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

/// Between the texts of two cases; JSON holds no such byte.
constexpr char separator = '\x1e';

/// In the child: the cases first ≤ i < last, the pictures of the first failure only.
std::string tried(const Test& test, std::size_t first, std::size_t last, const std::any& steps,
                  std::filesystem::path folder) {
    std::string texts;
    for (std::size_t i = first; i < last; ++i) {
        const CaseResult result = tried(test.cases[i], steps, folder);
        if (result.status != Status::pass) folder.clear();
        texts += text_of(result);
        texts += separator;
    }
    return texts;
}

CaseResult judged_alone(const Test& test, std::size_t index, const std::any& steps,
                        const std::filesystem::path& folder, double limit_s) {
    const ChildEnd end =
        run_in_child([&] { return tried(test, index, index + 1, steps, folder); }, limit_s);
    if (end.how == ChildEnd::How::timed_out) {
        return {Status::timed_out,
                failure(fmt::format("not done after {:g} s: an endless loop?", limit_s)),
                {}};
    }
    if (end.how == ChildEnd::How::crashed) {
        return {Status::crashed, failure("crashed: " + end.text), {}};
    }
    return result_of(end.text.substr(0, end.text.find(separator)));
}

/// Each case in a process of its own.
std::vector<CaseResult> judged_one_by_one(const Test& test, const std::any& steps,
                                          const std::filesystem::path& folder, double limit_s) {
    std::vector<CaseResult> results;
    bool pictured = false, over = false;
    for (std::size_t i = 0; i < test.cases.size(); ++i) {
        if (over) {
            // A second wait would tell nothing new.
            results.push_back({Status::timed_out, failure("not tried"), {}});
            continue;
        }
        results.push_back(judged_alone(test, i, steps, pictured ? "" : folder, limit_s));
        pictured = pictured || results.back().status != Status::pass;
        over = results.back().status == Status::timed_out;
    }
    return results;
}

/// All in one process, as starting one takes longer than most cases; one by one when it does not
/// come to its end.
std::vector<CaseResult> judged(const Test& test, const std::any& steps,
                               const JudgeOptions& options) {
    const auto folder =
        options.pictures.empty() ? std::filesystem::path() : options.pictures / test.id;
    const ChildEnd end = run_in_child(
        [&] { return tried(test, 0, test.cases.size(), steps, folder); }, options.limit_s);
    const std::vector<std::string> texts = split(end.text, separator);
    if (end.how != ChildEnd::How::finished || texts.size() != test.cases.size() + 1) {
        return judged_one_by_one(test, steps, folder, options.limit_s);
    }
    std::vector<CaseResult> results;
    for (std::size_t i = 0; i < test.cases.size(); ++i) results.push_back(result_of(texts[i]));
    return results;
}

/// How alike two signatures of one case are: elements in both, elements in either.
struct Likeness {
    std::size_t both = 0, either = 0;
    void add(const CaseResult& a, const CaseResult& b) {
        if (a.status == Status::pass && b.status == Status::pass) return;
        if (a.finding.signature.empty() && b.finding.signature.empty()) {
            // Nothing to count, but the same sort of end counts as one thing.
            both += a.status == b.status && a.finding.what == b.finding.what ? 1 : 0;
            ++either;
            return;
        }
        std::vector<std::uint32_t> shared;
        std::set_intersection(a.finding.signature.begin(), a.finding.signature.end(),
                              b.finding.signature.begin(), b.finding.signature.end(),
                              std::back_inserter(shared));
        both += shared.size();
        either += a.finding.signature.size() + b.finding.signature.size() - shared.size();
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
    return static_cast<std::size_t>(
        std::count_if(cases.begin(), cases.end(),
                      [](const CaseResult& each) { return each.status != Status::pass; }));
}

Status TestResult::status() const {
    const std::size_t first = first_failure();
    return first == cases.size() ? Status::pass : cases[first].status;
}

TestResult judge(const Test& test, const std::any& steps, const JudgeOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    TestResult result{.id = test.id, .max_points = test.points};
    for (const Case& each : test.cases) result.case_names.push_back(each.name);
    result.cases = judged(test, steps, options);
    const double passed = static_cast<double>(result.cases.size() - result.failures());
    result.points = test.points * passed / static_cast<double>(result.cases.size());
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

double likeness(std::span<const TestResult> some, std::span<const TestResult> others) {
    Likeness sum;
    for (std::size_t test = 0; test < some.size(); ++test) {
        for (std::size_t i = 0; i < some[test].cases.size(); ++i) {
            sum.add(some[test].cases[i], others[test].cases[i]);
        }
    }
    return sum.index();
}

}  // namespace luch::grading
