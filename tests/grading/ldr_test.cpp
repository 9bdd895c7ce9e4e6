#include "techniques/ldr/ldr.h"

#include "framework/grading/check.h"
#include "framework/grading/checker.h"
#include "tests/testing/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::homework::ldr {
techniques::ldr::Steps steps();
grading::Checker checker();
}  // namespace luch::homework::ldr

namespace luch {
namespace {

using homework::ldr::checker;
using techniques::ldr::Steps;
using ::testing::HasSubstr;

Ran check(const std::string& arguments) {
    return shell("'" LUCH_PROGRAM "' check ldr " + arguments);
}

TEST(CheckLdr, ScoresItsFloorAsItIsHandedOut) {
    const Ran ran = check("");
    EXPECT_EQ(ran.status, 1);
    for (const char* task : {"t1", "t2", "t3", "t4", "t5", "t6", "t7"}) {
        EXPECT_THAT(ran.text, HasSubstr(std::string("NOT ATTEMPTED ldr.") + task + "  0/"));
    }
    EXPECT_THAT(ran.text, HasSubstr("0 of 28 points"));
}

TEST(CheckLdr, FindsEveryKnownMistakeAndKnowsItByItsFailures) {
    const Ran ran = check("--mutants");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("34 mutants, every one fails"));
}

TEST(CheckLdr, LetsEveryHonestVariantPass) {
    const Ran ran = check("--variants");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("16 honest variants, every one has all points"));
}

TEST(CheckLdr, DoesSoOnHiddenPicturesToo) {
    const Ran ran = check("--mutants --variants --seed 20261122");
    EXPECT_EQ(ran.status, 0) << ran.text;
}

TEST(CheckLdr, HasTheReferenceOutputsOfTheReferenceSteps) {
    const Ran ran = check("--regenerate");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_EQ(ran.text, "nothing has changed\n");
}

TEST(CheckLdr, KeepsItsReferenceOutputsSmall) {
    std::uintmax_t bytes = 0;
    const auto folder = std::filesystem::path(LUCH_SOURCE_DIR) / "homework/ldr/reference";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) bytes += entry.file_size();
    }
    EXPECT_GT(bytes, 100'000u);
    EXPECT_LE(bytes, 300'000u);
}

/// The points of every task when only this step is written.
template <class Step>
std::vector<double> points_with(Step Steps::*step) {
    Steps steps = homework::ldr::steps();
    steps.*step = techniques::ldr::reference().*step;
    grading::Homework homework = checker().make(LUCH_SOURCE_DIR, std::nullopt);
    homework.yours = steps;
    std::vector<double> points;
    for (const auto& task : grading::check(homework, {}).tasks) points.push_back(task.points());
    return points;
}

TEST(CheckLdr, LetsEachTaskBeDoneFirst) {
    using Points = std::vector<double>;
    EXPECT_EQ(points_with(&Steps::encode), (Points{4, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::add), (Points{0, 4, 0, 0, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::modulate), (Points{0, 0, 4, 0, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::mix), (Points{0, 0, 0, 4, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::lerp), (Points{0, 0, 0, 0, 4, 0, 0}));
    EXPECT_EQ(points_with(&Steps::accumulate), (Points{0, 0, 0, 0, 0, 3, 0}));
    EXPECT_EQ(points_with(&Steps::resolve), (Points{0, 0, 0, 0, 0, 0, 5}));
}

}  // namespace
}  // namespace luch
