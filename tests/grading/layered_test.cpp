#include "techniques/layered/layered.h"

#include "framework/base/files.h"
#include "framework/grading/check.h"
#include "framework/grading/checker.h"
#include "framework/image/io.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::homework::layered {
techniques::layered::Steps steps();
grading::Checker checker();
}  // namespace luch::homework::layered

namespace luch {
namespace {

using homework::layered::checker;
using techniques::layered::Steps;
using ::testing::HasSubstr;

Ran check(const std::string& arguments) {
    return shell("'" LUCH_PROGRAM "' check layered " + arguments);
}

TEST(CheckLayered, ScoresItsFloorAsItIsHandedOut) {
    const Ran ran = check("");
    EXPECT_EQ(ran.status, 1);
    for (const char* task : {"t1", "t2", "t3", "t4", "t5"}) {
        EXPECT_THAT(ran.text, HasSubstr(std::string("NOT ATTEMPTED layered.") + task + "  0/"));
    }
    EXPECT_THAT(ran.text, HasSubstr("0 of 22 points"));
}

TEST(CheckLayered, FindsEveryKnownMistakeAndKnowsItByItsFailures) {
    const Ran ran = check("--mutants");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("32 mutants, every one fails"));
}

TEST(CheckLayered, LetsEveryHonestVariantPass) {
    const Ran ran = check("--variants");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("13 honest variants, every one has all points"));
}

TEST(CheckLayered, DoesSoOnHiddenScenesToo) {
    const Ran ran = check("--mutants --variants --seed 20261122");
    EXPECT_EQ(ran.status, 0) << ran.text;
}

TEST(CheckLayered, HasTheReferenceOutputsOfTheReferenceSteps) {
    const Ran ran = check("--regenerate");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_EQ(ran.text, "nothing has changed\n");
}

TEST(CheckLayered, KeepsItsReferenceOutputsSmall) {
    std::uintmax_t bytes = 0;
    const auto folder = std::filesystem::path(LUCH_SOURCE_DIR) / "homework/layered/reference";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) bytes += entry.file_size();
    }
    EXPECT_GT(bytes, 50'000u);
    EXPECT_LE(bytes, 300'000u);
}

TEST(CheckLayered, HasTheHandoutsPicturesOfTheReferenceSteps) {
    const std::filesystem::path homework = LUCH_SOURCE_DIR "/homework/layered";
    const auto folder = own_folder();
    std::uintmax_t bytes = 0;
    for (const auto& picture : checker().handout(LUCH_SOURCE_DIR)) {
        const std::string file = "pictures/" + picture.name + ".png";
        write_picture(folder / "made.png", picture.pixels.view());
        EXPECT_EQ(read_picture(homework / file).pixels, read_picture(folder / "made.png").pixels)
            << file << ": luch check layered --handout makes it again";
        for (const char* handout : {"README.md", "README.bg.md"}) {
            EXPECT_THAT(read_text(homework / handout), HasSubstr("](" + file + ")")) << handout;
        }
        bytes += file_size(homework / file);
    }
    EXPECT_GT(bytes, 20'000u);
    EXPECT_LE(bytes, 150'000u);
    std::filesystem::remove_all(folder);
}

/// The points of every task when only this step is written.
template <class Step>
std::vector<double> points_with(Step Steps::*step) {
    Steps steps = homework::layered::steps();
    steps.*step = techniques::layered::reference().*step;
    grading::Homework homework = checker().make(LUCH_SOURCE_DIR, std::nullopt);
    homework.yours = steps;
    std::vector<double> points;
    for (const auto& task : grading::check(homework, {}).tasks) points.push_back(task.points());
    return points;
}

TEST(CheckLayered, LetsEachTaskBeDoneFirst) {
    using Points = std::vector<double>;
    EXPECT_EQ(points_with(&Steps::cut), (Points{3, 0, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::coc), (Points{0, 4, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::gaussian), (Points{0, 0, 5, 0, 0}));
    EXPECT_EQ(points_with(&Steps::disc), (Points{0, 0, 0, 6, 0}));
    EXPECT_EQ(points_with(&Steps::over), (Points{0, 0, 0, 0, 4}));
}

}  // namespace
}  // namespace luch
