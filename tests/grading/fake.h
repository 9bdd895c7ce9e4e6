#pragma once

#include "framework/grading/homework.h"
#include "framework/technique/todo.h"

#include <csignal>
#include <stdexcept>

// A homework of one step, square a number, for tests of what checks homeworks.
namespace luch::grading::fake {

struct Steps {
    int (*square)(int);
};

inline int right(int x) {
    return x * x;
}
inline int doubled(int x) {
    return 2 * x;
}
inline int off_by_one(int x) {
    return x * x + 1;
}
inline int hole(int) {
    LUCH_TODO("fake.t1");
}
inline int crash(int x) {
    if (x > 2) std::raise(SIGSEGV);
    return x * x;
}
inline int leaves(int) {
    std::exit(0);
}
inline int loop(int x) {
    for (volatile bool forever = true; forever;) {
    }
    return x;
}
inline int throws(int) {
    throw std::runtime_error("no squares today");
}

inline Finding squares(const std::any& steps, int from, int to) {
    Finding finding;
    for (int x = from; x < to; ++x) {
        const int got = std::any_cast<Steps>(steps).square(x);
        if (got == x * x) continue;
        if (finding.wrong.empty()) {
            finding.first = "(" + std::to_string(x) + ",0) expected " + std::to_string(x * x) +
                            ", got " + std::to_string(got);
            finding.pixel = std::to_string(x) + ",0";
        }
        finding.wrong.push_back(static_cast<std::uint32_t>(x));
    }
    finding.passed = finding.wrong.empty();
    finding.what = std::to_string(finding.wrong.size()) + " squares are wrong";
    for (const char* name : {"yours", "reference", "difference"}) {
        finding.pictures.push_back({name, Image<Rgb>({2, 2})});
    }
    return finding;
}

inline Test test_of(const std::string& id, double points) {
    const auto case_of = [](const char* name, int from, int to) {
        return Case{name, "scenes/fake.scene",
                    [=](const std::any& steps) { return squares(steps, from, to); }};
    };
    return {id, points, {case_of("small", 0, 3), case_of("large", 3, 9)}};
}

/// Two tasks of 4 and 2 points; the second has steps of its own, which are right.
inline Homework homework(int (*yours)(int)) {
    Homework homework;
    homework.topic = "fake";
    homework.readme = "homework/fake/README.md";
    homework.yours = Steps{yours};
    homework.tasks = {{"fake.t1", "squares", {test_of("fake.t1.squares", 4)}},
                      {"fake.t2", "ones", {}}};
    homework.tasks[1].tests.push_back(
        {"fake.t2.one", 2, {{"one", "", [](const std::any&) { return Finding(); }}}});
    homework.mutants = {{"doubled", "fake.t1", "2x instead of x²", Steps{doubled}},
                        {"off_by_one", "fake.t1", "1 too many", Steps{off_by_one}}};
    homework.variants = {{"right", "fake.t1", "the same", Steps{right}}};
    return homework;
}

}  // namespace luch::grading::fake
