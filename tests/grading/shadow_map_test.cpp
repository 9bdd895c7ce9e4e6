#include "techniques/shadow_map/shadow_map.h"

#include "framework/grading/check.h"
#include "tests/grading/checked_homework.h"
#include "tests/testing/own_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

namespace luch::homework::shadow_map {
techniques::shadow_map::Steps steps();
grading::Checker checker();
}  // namespace luch::homework::shadow_map

namespace luch {

using techniques::shadow_map::CubeMap;
using techniques::shadow_map::Receiver;
using techniques::shadow_map::Steps;
using techniques::shadow_map::Texel;

namespace testing {

CheckedHomework checked_homework() {
    return {.topic = "shadow_map",
            .checker = homework::shadow_map::checker(),
            .points = {4, 2, 5, 4, 3, 5, 5},
            .mutants = 105,
            .variants = 20,
            .alone = each_alone(homework::shadow_map::steps(), techniques::shadow_map::reference(),
                                &Steps::texel_of, &Steps::direction_of, &Steps::render_face,
                                &Steps::bias, &Steps::lit, &Steps::pcf, &Steps::light_points)};
}

}  // namespace testing

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

grading::Report checked(const Steps& steps, const grading::JudgeOptions& judge) {
    grading::Homework homework =
        homework::shadow_map::checker().make(LUCH_SOURCE_DIR, std::nullopt);
    homework.yours = steps;
    grading::CheckOptions options;
    options.judge = judge;
    return grading::check(homework, options);
}

TEST(CheckShadowMap, TakesOnlyItsOwnPointsForACrashAndForALoop) {
    Steps steps = techniques::shadow_map::reference();
    steps.bias = [](std::span<const Receiver>, int, std::span<float>) { std::raise(SIGSEGV); };
    steps.direction_of = [](std::span<const Texel>, int, std::span<Vec3>) {
        for (volatile int forever = 1; forever != 0;) {
        }
    };
    const grading::Report report = checked(steps, {0.5, {}});
    std::vector<double> points;
    for (const auto& task : report.tasks) points.push_back(task.points());
    EXPECT_EQ(points, (std::vector<double>{4, 0, 5, 0, 3, 5, 5}));
    EXPECT_EQ(report.tasks[3].status(), grading::Status::crashed);
    EXPECT_EQ(report.tasks[1].status(), grading::Status::timed_out);
}

/// Compares as lit() should, but forgets the bias.
void lit_without_bias(const CubeMap& map, std::span<const Receiver> receivers,
                      std::span<const float> biases, std::span<float> shares) {
    const std::vector<float> none(biases.size(), 0);
    techniques::shadow_map::reference().lit(map, receivers, none, shares);
}

TEST(CheckShadowMap, SaysWhatIsWrongWhereWhyAndHowToSeeIt) {
    Steps steps = homework::shadow_map::steps();
    steps.lit = lit_without_bias;
    const auto folder = own_folder();
    const grading::Report report = checked(steps, {5, folder});
    const std::string text = grading::task_text(report, report.tasks[4]);
    EXPECT_THAT(text, AllOf(HasSubstr("FAIL shadow_map.t5.shadows  0/1.5\n"),
                            HasSubstr("pixels have the wrong share of light\n  first: ("),
                            HasSubstr("expected 1, got 0\n  likely: the bias is not added: acne — "
                                      "homework/shadow_map/README.md#t5\n"),
                            HasSubstr("/shadow_map.t5.shadows/{yours,reference,difference}.png\n"),
                            HasSubstr("replay: luch view homework/shadow_map/scenes/columns.scene "
                                      "-t homework/shadow_map --pixel ")));
    for (const char* picture : {"yours", "reference", "difference"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / "shadow_map.t5.shadows" /
                                            (std::string(picture) + ".png")));
    }
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace luch
