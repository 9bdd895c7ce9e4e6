#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

#include <any>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

// A homework as its checker sees it: tasks, each with tests, each tried on several cases (scenes);
// the table of steps that is being checked; and other tables that must fail or must pass.
namespace luch::grading {

/// A picture that goes with a failure, in linear light.
struct NamedPicture {
    std::string name;  ///< "yours", "reference" or "difference"
    Image<Rgb> pixels;
};

/// What one case of a test found.
struct Finding {
    bool passed = true;
    std::string what{};   ///< "37 of 4096 pixels have the wrong id, all within 1 px of an edge"
    std::string first{};  ///< the first thing that is wrong: "(41,17) expected 3, got 0"
    std::string pixel{};  ///< "41,17" when the first thing is a pixel, for the replay command
    std::vector<std::uint32_t> wrong{};  ///< elements (pixels, triangles), rising
    /// A number for each wrong element, made of which it is and how it is wrong. Like mistakes have
    /// like signatures.
    std::vector<std::uint32_t> signature{};
    std::vector<NamedPicture> pictures{};
};

/// A failure without pictures, about the homework as a whole.
Finding failure(std::string what, std::string first = "");

/// A test on one scene. It runs in a process of its own, so it may crash.
struct Case {
    std::string name;   ///< of the scene or sample: "balls"
    std::string scene;  ///< file to look at it in a viewer; "" when there is none
    /// `steps` holds the homework's own table of steps.
    std::function<Finding(const std::any& steps)> run;
};

/// A test is worth its points times the share of its cases that pass.
struct Test {
    std::string id;  ///< "vista.t3.cut_by_the_frame"
    double points = 1;
    std::vector<Case> cases;
};

struct Task {
    std::string id;  ///< "vista.t3": in the code's hole, the handout's anchor and the tests' prefix
    std::string title;
    std::vector<Test> tests;
};

/// A table of steps besides the student's own.
struct Other {
    std::string name;
    std::string task;   ///< the one that it changes
    std::string cause;  ///< of a mutant: the mistake in words; of a variant: what is different
    std::any steps;
};

struct Homework {
    std::string topic;   ///< "vista"
    std::string readme;  ///< whose anchors #t1… are the tasks
    std::any yours;      ///< what is checked
    std::vector<Task> tasks;
    std::vector<Other> mutants;   ///< known mistakes: every one must fail, on two cases or more
    std::vector<Other> variants;  ///< honest solutions: every one must have all points
};

/// Points of a task or of a whole homework.
double points_of(const Task& task);
double points_of(const Homework& homework);

/// Leaves only what `filter` names: a task ("vista.t3") or a test. Throws Error that lists the
/// nearest names when nothing is left; so does a homework whose tests have no cases.
void keep_only(Homework& homework, const std::string& filter);

}  // namespace luch::grading
