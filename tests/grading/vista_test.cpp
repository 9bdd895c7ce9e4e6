#include "techniques/vista/vista.h"

#include "framework/base/files.h"
#include "framework/grading/check.h"
#include "framework/grading/checker.h"
#include "framework/image/io.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::homework::vista {
techniques::vista::Steps steps();
grading::Checker checker();
}  // namespace luch::homework::vista

namespace luch {
namespace {

using homework::vista::checker;
using techniques::vista::Steps;
using ::testing::HasSubstr;

Ran check(const std::string& arguments) {
    return shell("'" LUCH_PROGRAM "' check vista " + arguments);
}

TEST(CheckVista, ScoresItsFloorAsItIsHandedOut) {
    const Ran ran = check("");
    EXPECT_EQ(ran.status, 1);
    for (const char* task : {"t1", "t2", "t3", "t4", "t5", "t6", "t7"}) {
        EXPECT_THAT(ran.text, HasSubstr(std::string("NOT ATTEMPTED vista.") + task + "  0/"));
    }
    EXPECT_THAT(ran.text, HasSubstr("0 of 28 points"));
}

TEST(CheckVista, FindsEveryKnownMistakeAndKnowsItByItsFailures) {
    const Ran ran = check("--mutants");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("37 mutants, every one fails"));
}

TEST(CheckVista, LetsEveryHonestVariantPass) {
    const Ran ran = check("--variants");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("17 honest variants, every one has all points"));
}

TEST(CheckVista, DoesSoOnHiddenScenesToo) {
    const Ran ran = check("--mutants --variants --seed 20261122");
    EXPECT_EQ(ran.status, 0) << ran.text;
}

TEST(CheckVista, HasTheReferenceOutputsOfTheReferenceSteps) {
    const Ran ran = check("--regenerate");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_EQ(ran.text, "nothing has changed\n");
}

TEST(CheckVista, KeepsItsReferenceOutputsSmall) {
    std::uintmax_t bytes = 0;
    const auto folder = std::filesystem::path(LUCH_SOURCE_DIR) / "homework/vista/reference";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) bytes += entry.file_size();
    }
    EXPECT_GT(bytes, 100'000u);
    EXPECT_LE(bytes, 300'000u);
}

TEST(CheckVista, IsAUsersMistakeWithAnUnknownTask) {
    const Ran ran = check("--task vista.t9");
    EXPECT_EQ(ran.status, 2);
    EXPECT_THAT(ran.text, HasSubstr("did you mean vista.t"));
    EXPECT_EQ(check("--seed x").status, 2);
}

TEST(CheckVista, HasTheHandoutsPicturesOfTheReferenceSteps) {
    const std::filesystem::path homework = LUCH_SOURCE_DIR "/homework/vista";
    const auto folder = own_folder();
    std::uintmax_t bytes = 0;
    for (const auto& picture : checker().handout(LUCH_SOURCE_DIR)) {
        const std::string file = "pictures/" + picture.name + ".png";
        write_picture(folder / "made.png", picture.pixels.view());
        EXPECT_EQ(read_picture(homework / file).pixels, read_picture(folder / "made.png").pixels)
            << file << ": luch check vista --handout makes it again";
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
    Steps steps = homework::vista::steps();
    steps.*step = techniques::vista::reference().*step;
    grading::Homework homework = checker().make(LUCH_SOURCE_DIR, std::nullopt);
    homework.yours = steps;
    std::vector<double> points;
    for (const auto& task : grading::check(homework, {}).tasks) points.push_back(task.points());
    return points;
}

TEST(CheckVista, LetsEachTaskBeDoneFirst) {
    using Points = std::vector<double>;
    EXPECT_EQ(points_with(&Steps::lod), (Points{2, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::tessellate), (Points{0, 5, 0, 0, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::clip), (Points{0, 0, 4, 0, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::sort), (Points{0, 0, 0, 2, 0, 0, 0}));
    EXPECT_EQ(points_with(&Steps::project), (Points{0, 0, 0, 0, 4, 0, 0}));
    EXPECT_EQ(points_with(&Steps::rasterise), (Points{0, 0, 0, 0, 0, 6, 0}));
    EXPECT_EQ(points_with(&Steps::look_up), (Points{0, 0, 0, 0, 0, 0, 5}));
}

}  // namespace
}  // namespace luch
