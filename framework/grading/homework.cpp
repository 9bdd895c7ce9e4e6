#include "framework/grading/homework.h"

#include "framework/base/error.h"
#include "framework/base/text.h"

#include <utility>

namespace luch::grading {

Finding failure(std::string what, std::string first) {
    return {.passed = false, .what = std::move(what), .first = std::move(first)};
}

double points_of(const Task& task) {
    double sum = 0;
    for (const Test& test : task.tests) sum += test.points;
    return sum;
}

double points_of(const Homework& homework) {
    double sum = 0;
    for (const Task& task : homework.tasks) sum += points_of(task);
    return sum;
}

void keep_only(Homework& homework, const std::string& filter) {
    std::vector<std::string> names;
    for (Task& task : homework.tasks) {
        names.push_back(task.id);
        for (const Test& test : task.tests) names.push_back(test.id);
        if (filter.empty() || task.id == filter) continue;
        std::erase_if(task.tests, [&](const Test& test) { return test.id != filter; });
    }
    std::erase_if(homework.tasks, [](const Task& task) { return task.tests.empty(); });
    if (homework.tasks.empty()) {
        const std::vector<std::string_view> views(names.begin(), names.end());
        throw Error("--task: no task or test of " + homework.topic + " is called \"" + filter +
                    "\"; " + did_you_mean(filter, views));
    }
    for (const Task& task : homework.tasks) {
        for (const Test& test : task.tests) {
            if (test.cases.empty()) {
                throw Error(test.id +
                            ": has no case to be tried on; are its reference files "
                            "there?");
            }
        }
    }
}

}  // namespace luch::grading
