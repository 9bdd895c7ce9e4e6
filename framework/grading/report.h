#pragma once

#include "framework/grading/judge.h"

#include <cstdint>
#include <optional>

namespace luch::grading {

/// What a check of a homework found so far.
struct Report {
    std::string topic, readme;
    std::optional<std::uint64_t> seed{};  ///< of the hidden cases, if they were added
    bool complete = false;                ///< whether all tests were run
    struct Task {
        std::string id, title;
        double max_points = 0;
        std::vector<TestResult> tests{};
        std::vector<std::string> scenes{};  ///< of each test: where its first failure can be seen
        std::string likely{};               ///< the cause that its failures look like; "" unknown

        [[nodiscard]] double points() const;
        /// not_written when a test met a hole and none passed; else the first that is not pass.
        [[nodiscard]] Status status() const;
    };
    std::vector<Task> tasks{};

    [[nodiscard]] double points() const;
    [[nodiscard]] double max_points() const;
};

/// Points to a tenth, without a needless zero: "2.5".
std::string points_text(double points);

/// The command that shows a failure again.
std::string replay_command(const Report& report, const Report::Task& task, std::size_t test);

/// "#t3" of "vista.t3": where the handout speaks of a task.
std::string anchor_of(const std::string& task_id);

/// One task as a student reads it: a line for each test, under a failure what is wrong, where,
/// why perhaps, pictures, and how to see it again.
std::string task_text(const Report& report, const Report::Task& task);

/// The sum: "12.5 of 28 points; not attempted: vista.t4, vista.t6".
std::string sum_text(const Report& report);

/// report.json, schema luch/report/1.
void write_report_json(const Report& report, const std::filesystem::path& file);

}  // namespace luch::grading
