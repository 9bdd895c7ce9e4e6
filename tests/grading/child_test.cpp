#include "framework/grading/child.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace luch::grading {
namespace {

using How = ChildEnd::How;

ChildEnd run(const std::function<std::string()>& work, double limit_s = 20) {
    return run_in_child(work, limit_s);
}

TEST(Child, HandsBackWhatTheWorkReturns) {
    const std::string large(300'000, 'x');  // more than a pipe holds
    const ChildEnd end = run([&] { return large; });
    EXPECT_EQ(end.how, How::finished);
    EXPECT_EQ(end.text, large);
}

TEST(Child, DiesAloneAndSaysOfWhat) {
    const ChildEnd end = run([]() -> std::string {
        std::raise(SIGFPE);
        return "";
    });
    EXPECT_EQ(end.how, How::crashed);
    EXPECT_EQ(end.text, "Floating point exception");
}

TEST(Child, IsACrashWhenItLeavesOrThrows) {
    for (const auto& work : std::initializer_list<std::function<std::string()>>{
             []() -> std::string { std::_Exit(0); },
             []() -> std::string { throw std::runtime_error("out of it"); }}) {
        EXPECT_EQ(run(work).how, How::crashed);
    }
}

TEST(Child, IsStoppedWhenItsTimeIsOver) {
    const ChildEnd end = run(
        []() -> std::string {
            while (true) pause();
        },
        0.05);
    EXPECT_EQ(end.how, How::timed_out);
}

TEST(Child, IsStoppedAlsoWhenItClosedThePipe) {
    const ChildEnd end = run([]() -> std::string {
        std::signal(SIGTERM, SIG_IGN);
        for (int file = 3; file < 64; ++file) close(file);
        while (true) pause();
    });
    EXPECT_EQ(end.how, How::crashed);
}

TEST(Child, ChangesNothingOfItsParent) {
    int value = 1;
    run([&] {
        value = 2;
        return std::string();
    });
    EXPECT_EQ(value, 1);
}

}  // namespace
}  // namespace luch::grading
