#include "framework/grading/report.h"

#include "framework/grading/check.h"
#include "framework/image/io.h"
#include "tests/grading/fake.h"
#include "tests/testing/own_folder.h"

#include <gtest/gtest.h>

namespace luch::grading {
namespace {

/// Right for small numbers only.
int half_right(int x) {
    return x < 3 ? x * x : 2 * x;
}

TEST(Report, SaysWhatWhereWhyAndHowToSeeItAgain) {
    const auto folder = own_folder();
    CheckOptions options;
    options.judge.pictures = folder / "out";
    const Report report = check(fake::homework(half_right), options);
    const std::string out = (folder / "out").string();
    EXPECT_EQ(task_text(report, report.tasks[0]),
              "FAIL fake.t1.squares  2/4\n"
              "  6 squares are wrong\n"
              "  first: (3,0) expected 9, got 6\n"
              "  likely: 2x instead of x² — homework/fake/README.md#t1\n"
              "  images: " +
                  out +
                  "/fake.t1.squares/{yours,reference,difference}.png\n"
                  "  replay: luch view scenes/fake.scene -t homework/fake --pixel 3,0\n");
    EXPECT_EQ(read_picture(folder / "out/fake.t1.squares/yours.png").pixels.size(), Size(2, 2));
    EXPECT_EQ(task_text(report, report.tasks[1]), "PASS fake.t2.one  2/2\n");
    EXPECT_EQ(sum_text(report), "4 of 6 points\n");
    std::filesystem::remove_all(folder);
}

TEST(Report, ReplaysByTheCheckWhereThereIsNoSceneToLookAt) {
    Homework homework = fake::homework(half_right);
    for (Case& each : homework.tasks[0].tests[0].cases) each.scene.clear();
    Report report = check(homework, {});
    EXPECT_EQ(replay_command(report, report.tasks[0], 0), "luch check fake --task fake.t1.squares");
    report.seed = 7;
    EXPECT_EQ(replay_command(report, report.tasks[0], 0),
              "luch check fake --task fake.t1.squares --seed 7");
}

TEST(Report, RoundsPointsToATenth) {
    EXPECT_EQ(points_text(2.5), "2.5");
    EXPECT_EQ(points_text(4.0 / 3), "1.3");
    EXPECT_EQ(points_text(3), "3");
}

}  // namespace
}  // namespace luch::grading
