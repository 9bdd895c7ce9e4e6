#pragma once

#include "framework/grading/checker.h"

#include <any>
#include <string>
#include <vector>

// What the tests of every homework's checker need to know of it.
namespace luch::testing {

struct CheckedHomework {
    std::string topic;
    grading::Checker checker;
    std::vector<double> points;  ///< of its tasks
    int mutants, variants;
    /// Tables of steps in which a task's is written and no other's.
    std::vector<std::any> alone;
};

/// Of the homework that the test program is about.
CheckedHomework checked_homework();

/// `holes`, in which one of the steps is the reference's: one after the other.
template <class Steps, class... Step>
std::vector<std::any> each_alone(const Steps& holes, const Steps& reference,
                                 Step Steps::*... step) {
    std::vector<std::any> tables;
    const auto add = [&](auto which) {
        Steps steps = holes;
        steps.*which = reference.*which;
        tables.emplace_back(steps);
    };
    (add(step), ...);
    return tables;
}

}  // namespace luch::testing
