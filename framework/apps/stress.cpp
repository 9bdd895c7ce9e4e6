#include "framework/apps/progress.h"
#include "framework/apps/verbs.h"
#include "framework/base/error.h"
#include "framework/base/json.h"
#include "framework/measure/numbers.h"
#include "framework/stress/cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

namespace luch {
namespace {

/// A table of cases about one thing: the core, or a technique.
struct Part {
    std::string name;
    std::vector<StressCase> cases;
};

/// How many cases ended in which way, in the order of StressVerdict.
using Ends = std::array<int, 4>;

int& of(Ends& ends, StressVerdict verdict) {
    return ends[static_cast<std::size_t>(verdict)];
}

/// The cases are many: what a table shows of one is a line.
void print_line(const StressCase& each, const StressResult& result) {
    fmt::print("{:>3}  {:<46} {:<34} {:<14} {}\n", each.row, each.name, each.expected,
               stress::to_string(result.verdict), result.got);
    std::fflush(stdout);
}

Json json_of(const Part& part, const StressCase& each, const StressResult& result, double seconds) {
    return Json::object()
        .set("about", part.name)
        .set("row", each.row)
        .set("case", each.name)
        .set("expected", each.expected)
        .set("got", result.got)
        .set("verdict", stress::to_string(result.verdict))
        .set("seconds", seconds);
}

class Stress final : public Verb {
 public:
    std::string_view name() const override { return "stress"; }
    std::string_view summary() const override { return "the extreme cases, as a table"; }
    std::string_view examples() const override {
        return "  luch stress                        the core, baseline and path\n"
               "  luch stress -t homework/vista      yours; what is not written is counted apart\n"
               "  luch stress -t vista --row 13      fields of view, the camera in odd places\n"
               "  luch stress --full --json all.json at the stated size: for many minutes\n";
    }
    void declare(Arguments& arguments) override {
        arguments.option("-t,--technique", technique_, "NAME",
                         "only this technique [the core, baseline and path]");
        arguments.option("--row", row_, "N", "only this row of the table [all]");
        arguments.flag("--full", full_, "at the stated size: millions of rays and frames");
        arguments.flag("--list", list_, "name the cases and run none");
        arguments.option("--json", json_, "FILE", "write the table as JSON");
    }
    int run() override {
        const std::vector<Part> parts = chosen();
        std::size_t count = 0;
        for (const Part& part : parts) count += part.cases.size();
        if (count == 0) {
            throw Error(
                fmt::format("--row {}: there is no such row here; --list shows them", row_));
        }
        if (list_) return print_list(parts);
        const auto start = std::chrono::steady_clock::now();
        Ends ends{};
        Json all = Json::array();
        std::size_t begun = 0;
        for (const Part& part : parts) {
            fmt::print("{}\n", part.name);
            for (const StressCase& each : part.cases) {
                const double done = static_cast<double>(begun++) / static_cast<double>(count);
                const auto [result, seconds] = judged(each, done);
                ++of(ends, result.verdict);
                print_line(each, result);
                all.push(json_of(part, each, result, seconds));
            }
        }
        print_sum(ends, count, seconds_since(start));
        if (!json_.empty()) sum_json(ends, all).write(json_);
        return of(ends, StressVerdict::fail) == 0 ? 0 : 1;
    }

 private:
    struct Judged {
        StressResult result;
        double seconds;
    };
    Judged judged(const StressCase& each, double done) {
        const auto start = std::chrono::steady_clock::now();
        if (progress_.on_terminal()) progress_.step(done, each.name);
        Judged judged{stress::result_of(each), 0};
        judged.seconds = seconds_since(start);
        progress_.clear();
        return judged;
    }

    static double seconds_since(std::chrono::steady_clock::time_point start) {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    [[nodiscard]] std::vector<Part> chosen() const {
        std::vector<Part> parts;
        const TechniqueInfo& baseline = find_technique("baseline");
        const auto add = [&](const TechniqueInfo& info) {
            parts.push_back(
                {std::string(info.name), stress::technique_cases(info, baseline, full_)});
        };
        if (technique_.empty()) {
            parts.push_back({"the core", stress::core_cases(full_)});
            add(baseline);
            add(find_technique("path"));
        } else {
            add(find_technique(technique_));
        }
        if (row_ == 0) return parts;
        for (Part& part : parts) {
            std::erase_if(part.cases, [&](const StressCase& each) { return each.row != row_; });
        }
        std::erase_if(parts, [](const Part& part) { return part.cases.empty(); });
        return parts;
    }

    static int print_list(const std::vector<Part>& parts) {
        for (const Part& part : parts) {
            fmt::print("{}\n", part.name);
            for (const StressCase& each : part.cases) {
                fmt::print("{:>3}  {:<46} {}\n", each.row, each.name, each.expected);
            }
        }
        fmt::print(
            "Not here: other compilers and -O levels (row 21), which need builds of their own:\n"
            "they are for continuous integration.\n");
        return 0;
    }

    static void print_sum(Ends& ends, std::size_t count, double seconds) {
        fmt::print("{} in {}: {} pass, {} fail, {} not written, {} do not apply\n",
                   counted(count, "case"), duration(seconds), of(ends, StressVerdict::pass),
                   of(ends, StressVerdict::fail), of(ends, StressVerdict::not_written),
                   of(ends, StressVerdict::does_not_apply));
    }

    [[nodiscard]] Json sum_json(Ends& ends, const Json& cases) const {
        return Json::object()
            .set("version", LUCH_VERSION)
            .set("full", full_)
            .set("pass", of(ends, StressVerdict::pass))
            .set("fail", of(ends, StressVerdict::fail))
            .set("not_written", of(ends, StressVerdict::not_written))
            .set("does_not_apply", of(ends, StressVerdict::does_not_apply))
            .set("cases", cases);
    }

    std::string technique_, json_;
    int row_ = 0;
    bool full_ = false, list_ = false;
    Progress progress_;
};

}  // namespace

std::unique_ptr<Verb> make_stress() {
    return std::make_unique<Stress>();
}

}  // namespace luch
