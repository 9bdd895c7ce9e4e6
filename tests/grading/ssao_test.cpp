#include "techniques/ssao/ssao.h"

#include "framework/base/files.h"
#include "framework/grading/check.h"
#include "framework/grading/checker.h"
#include "framework/image/io.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::homework::ssao {
techniques::ssao::Steps steps();
grading::Checker checker();
}  // namespace luch::homework::ssao

namespace luch {
namespace {

using homework::ssao::checker;
using techniques::ssao::Steps;
using ::testing::HasSubstr;

Ran check(const std::string& arguments) {
    return shell("'" LUCH_PROGRAM "' check ssao " + arguments);
}

TEST(CheckSsao, ScoresItsFloorAsItIsHandedOut) {
    const Ran ran = check("");
    EXPECT_EQ(ran.status, 1);
    for (const char* task : {"t1", "t2", "t3", "t4", "t5", "t6", "t7"}) {
        EXPECT_THAT(ran.text, HasSubstr(std::string("NOT ATTEMPTED ssao.") + task + "  0/"));
    }
    EXPECT_THAT(ran.text, HasSubstr("0 of 32 points"));
}

TEST(CheckSsao, FindsEveryKnownMistakeAndKnowsItByItsFailures) {
    const Ran ran = check("--mutants");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("54 mutants, every one fails"));
}

TEST(CheckSsao, LetsEveryHonestVariantPass) {
    const Ran ran = check("--variants");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("14 honest variants, every one has all points"));
}

TEST(CheckSsao, DoesSoOnHiddenScenesToo) {
    const Ran ran = check("--mutants --variants --seed 20261122");
    EXPECT_EQ(ran.status, 0) << ran.text;
}

TEST(CheckSsao, HasTheReferenceOutputsOfTheReferenceSteps) {
    const Ran ran = check("--regenerate");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_EQ(ran.text, "nothing has changed\n");
}

TEST(CheckSsao, KeepsItsReferenceOutputsSmall) {
    std::uintmax_t bytes = 0;
    const auto folder = std::filesystem::path(LUCH_SOURCE_DIR) / "homework/ssao/reference";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) bytes += entry.file_size();
    }
    EXPECT_GT(bytes, 50'000u);
    EXPECT_LE(bytes, 300'000u);
}

TEST(CheckSsao, HasTheHandoutsPicturesOfTheReferenceSteps) {
    const std::filesystem::path homework = LUCH_SOURCE_DIR "/homework/ssao";
    const auto folder = own_folder();
    std::uintmax_t bytes = 0;
    for (const auto& picture : checker().handout(LUCH_SOURCE_DIR)) {
        const std::string file = "pictures/" + picture.name + ".png";
        write_picture(folder / "made.png", picture.pixels.view());
        EXPECT_EQ(read_picture(homework / file).pixels, read_picture(folder / "made.png").pixels)
            << file << ": luch check ssao --handout makes it again";
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
    Steps steps = homework::ssao::steps();
    steps.*step = techniques::ssao::reference().*step;
    grading::Homework homework = checker().make(LUCH_SOURCE_DIR, std::nullopt);
    homework.yours = steps;
    std::vector<double> points;
    for (const auto& task : grading::check(homework, {}).tasks) points.push_back(task.points());
    return points;
}

TEST(CheckSsao, LetsEachTaskBeDoneFirst) {
    using Points = std::vector<double>;
    EXPECT_EQ(points_with(&Steps::positions), (Points{4, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::normals), (Points{0, 4, 0, 0, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::kernel), (Points{0, 0, 4, 0, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::occlusion), (Points{0, 0, 0, 9, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::blur), (Points{0, 0, 0, 0, 5, 0, 0}));
    EXPECT_EQ(points_with(&Steps::upsample), (Points{0, 0, 0, 0, 0, 4, 0}));
    EXPECT_EQ(points_with(&Steps::apply), (Points{0, 0, 0, 0, 0, 0, 2}));
}

void crashes(ImageView<const Vec3>, Tile, ImageView<Vec3>) {
    std::abort();
}

void never_ends(ImageView<const float>, const Rgb&, Tile, ImageView<Rgb>) {
    for (volatile bool on = true; on;) {
    }
}

TEST(CheckSsao, TakesForACrashOrAnEndlessLoopItsOwnPointsOnly) {
    Steps steps = techniques::ssao::reference();
    steps.normals = crashes;
    steps.apply = never_ends;
    grading::Homework homework = checker().make(LUCH_SOURCE_DIR, std::nullopt);
    homework.yours = steps;
    grading::CheckOptions options;
    options.judge.limit_s = 1;
    std::vector<double> points;
    for (const auto& task : grading::check(homework, options).tasks)
        points.push_back(task.points());
    EXPECT_EQ(points, (std::vector<double>{4, 0, 4, 9, 5, 4, 0}));
}

}  // namespace
}  // namespace luch
