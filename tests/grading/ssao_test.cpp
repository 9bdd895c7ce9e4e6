#include "techniques/ssao/ssao.h"

#include "framework/grading/check.h"
#include "tests/grading/checked_homework.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace luch::homework::ssao {
techniques::ssao::Steps steps();
grading::Checker checker();
}  // namespace luch::homework::ssao

namespace luch {

using techniques::ssao::Steps;

testing::CheckedHomework testing::checked_homework() {
    return {.topic = "ssao",
            .checker = homework::ssao::checker(),
            .points = {4, 4, 4, 9, 5, 4, 2},
            .mutants = 54,
            .variants = 14,
            .alone = each_alone(homework::ssao::steps(), techniques::ssao::reference(),
                                &Steps::positions, &Steps::normals, &Steps::kernel,
                                &Steps::occlusion, &Steps::blur, &Steps::upsample, &Steps::apply)};
}

namespace {

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
    grading::Homework homework = homework::ssao::checker().make(LUCH_SOURCE_DIR, std::nullopt);
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
