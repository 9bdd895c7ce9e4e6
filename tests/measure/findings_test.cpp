#include "framework/measure/findings.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace luch {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

LabPoint point(double value, double ms, double rmse, double converged) {
    LabPoint point;
    point.value = value;
    point.frame_ms = ms;
    point.frames = 3;
    point.errors.rmse = rmse;
    point.linear_rmse = rmse;
    point.converged = Errors{};
    point.converged->rmse = converged;
    return point;
}

/// The baseline takes 10 ms a sample and has an error of 0.1/√spp; "quick" takes 1, 2 and 4 ms.
SceneReport known_report() {
    SceneReport scene;
    scene.scene = "known";
    scene.baseline = point(0, 10, 0, 0.1);
    LabTruth frame, converged;
    frame.name = "frame";
    frame.exact = true;
    converged.name = "converged";
    converged.samples = 100;
    converged.standard_error = 0.004;
    scene.truths = {frame, converged};
    scene.converged = "converged";
    LabSeries quick{"quick", "", "lod", "frame", {}, false, 0};
    quick.points = {point(1, 1, 0.2, 0.21), point(2, 2, 0.1, 0.12), point(4, 4, 0.04, 0.11)};
    LabSeries samples{"baseline", "", "spp", "converged", {}, true, -0.5};
    for (const double spp : {1.0, 2.0, 4.0, 8.0, 16.0}) {
        const double error = 0.1 / std::sqrt(spp);
        samples.points.push_back(point(spp, 10 * spp, error, error));
    }
    scene.series = {quick, samples};
    return scene;
}

std::vector<std::string> sentences(const SceneReport& scene, double good_enough = 0.05) {
    return findings(scene, {&find_metric("rmse"), good_enough});
}

TEST(Slopes, AreFittedOverTheParameterWithoutThePixelsCentre) {
    SceneReport scene = known_report();
    LabSeries& samples = scene.series[1];
    samples.points[0].linear_rmse = 77;  // one sample is no random one
    const auto slope = slope_of(samples);
    ASSERT_TRUE(slope);
    EXPECT_NEAR(slope->fit.slope, -0.5, 1e-9);
    EXPECT_EQ(slope->fit.points, 4);
    EXPECT_FALSE(slope_of(scene.series[0]));  // nothing is expected of it
    samples.points.resize(3);
    EXPECT_FALSE(slope_of(samples));
}

TEST(Slopes, AreWarnedOfWhenTheyAreOffByMoreThanATenth) {
    SceneReport scene = known_report();
    EXPECT_THAT(sentences(scene), Contains(HasSubstr("over spp: -0.50")));
    scene.series[1].slope = -0.59;
    EXPECT_THAT(sentences(scene), Not(Contains(HasSubstr("WARNING: baseline"))));
    scene.series[1].slope = -0.61;
    EXPECT_THAT(sentences(scene), Contains(HasSubstr("WARNING: baseline: slope")));
    EXPECT_THAT(sentences(scene), Contains(HasSubstr("more slowly than it should")));
    scene.series[1].slope = -0.39;
    EXPECT_THAT(sentences(scene), Contains(HasSubstr("faster than was expected")));
}

TEST(Slopes, OfIndependentFramesAreToBeAHalf) {
    SceneReport scene = known_report();
    EXPECT_FALSE(passes_slope(scene.series[1]));
    scene.series[1].passes = {{1, 2, 4}, {0.1, 0.09, 0.08}};
    EXPECT_THAT(sentences(scene),
                Contains(HasSubstr("WARNING: baseline: slope of the linear RMSE over the number")));
}

TEST(Efficiency, IsOfUnbiasedMethodsOnlyAndTheFloorOfTheOthers) {
    const SceneReport scene = known_report();
    const auto efficiency = efficiency_of(scene.series[1]);
    ASSERT_TRUE(efficiency);
    EXPECT_NEAR(efficiency->value, 1 / (0.1 * 0.1 * 0.010), 1e-6);
    EXPECT_FALSE(efficiency_of(scene.series[0]));
    EXPECT_EQ(floor_of(scene.series[0]), 0.04);
    EXPECT_FALSE(floor_of(scene.series[1]));
}

TEST(Planes, HoldWhatWasMeasuredAgainstOneTruth) {
    const SceneReport scene = known_report();
    const auto planes = planes_of(scene, find_metric("rmse"));
    ASSERT_EQ(planes.size(), 2u);
    EXPECT_EQ(planes[0].points.size(), 4u);  // quick's, and the baseline's frame, which is exact
    EXPECT_EQ(planes[0].points[3].at.error, 0);
    EXPECT_EQ(planes[1].points.size(), 8u);
    const auto pareto = [](const ErrorPlane& plane) {
        return std::count_if(plane.points.begin(), plane.points.end(),
                             [](const PlanePoint& p) { return p.pareto; });
    };
    EXPECT_EQ(pareto(planes[0]), 4);
    EXPECT_EQ(pareto(planes[1]), 8);
    EXPECT_EQ(planes[1].points[0].at.error, 0.21);
}

TEST(Planes, LeaveOutWhatIsNotFiniteOrDidNotRun) {
    SceneReport scene = known_report();
    scene.series[0].points[0].errors.non_finite.count = 1;
    scene.series[0].points[1].not_run = "no";
    EXPECT_EQ(planes_of(scene, find_metric("rmse"))[0].points.size(), 2u);
}

TEST(EqualTime, NamesTheBestAndByHowMuch) {
    const SceneReport scene = known_report();
    const ErrorPlane plane = planes_of(scene, find_metric("rmse"))[1];
    const auto rows = at_equal_time(plane, 10);
    ASSERT_GE(rows.size(), 2u);
    EXPECT_EQ(rows[0].ms, 10);
    EXPECT_EQ(rows[0].errors[0].technique, "baseline");
    EXPECT_NEAR(rows[0].errors[0].value, 0.1, 1e-12);
    EXPECT_NEAR(rows[0].errors[1].value, 0.11, 1e-12);
    EXPECT_NEAR(rows[1].errors[0].value, 0.05, 1e-12);  // 40 ms: four samples
    EXPECT_THAT(sentences(scene), Contains(HasSubstr("within 40.0 ms, against converged: baseline "
                                                     "is best, RMSE 0.0500, 2.20 × better than "
                                                     "quick")));
}

TEST(EqualTime, SaysNothingAgainThatIsKnown) {
    const SceneReport scene = known_report();
    // The baseline's frame is exact from 10 ms on, and more time makes nothing better.
    const auto rows = at_equal_time(planes_of(scene, find_metric("rmse"))[0], 10);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].errors[0].value, 0);
}

TEST(EqualError, NamesTheFastestAndWhoDoesNotReachIt) {
    const SceneReport scene = known_report();
    const auto planes = planes_of(scene, find_metric("rmse"));
    const EqualError frame = at_equal_error(planes[0], 0.1);
    ASSERT_EQ(frame.ms.size(), 2u);
    EXPECT_EQ(frame.ms[0].technique, "quick");
    EXPECT_NEAR(frame.ms[0].value, 2, 1e-9);
    const EqualError converged = at_equal_error(planes[1], 0.05);
    ASSERT_EQ(converged.ms.size(), 1u);
    EXPECT_NEAR(converged.ms[0].value, 40, 1e-9);
    EXPECT_THAT(converged.not_reached, ::testing::ElementsAre("quick"));
    EXPECT_THAT(sentences(scene, 0.1), Contains(HasSubstr("quick is fastest, 2.00 ms, 5.00 × "
                                                          "faster than baseline")));
    EXPECT_THAT(sentences(scene, 0.001), Contains(HasSubstr("nothing reaches it")));
}

TEST(Truths, AreWarnedOfWhenTheirOwnErrorIsMoreThanAFifthOfTheSmallest) {
    SceneReport scene = known_report();
    // The smallest error against it is 0.025.
    EXPECT_THAT(sentences(scene)[0],
                HasSubstr("truth, converged: its own standard error is 0.0040"));
    scene.truths[1].standard_error = 0.01;
    EXPECT_THAT(sentences(scene)[0], ::testing::StartsWith("WARNING: truth, converged"));
    EXPECT_THAT(sentences(scene)[0], HasSubstr("about 400 samples a pixel would do"));
}

TEST(BreakEven, IsToldWhereThereIsSomethingToPayBack) {
    SceneReport scene = known_report();
    for (LabPoint& p : scene.series[0].points) p.prepare_ms = 60;
    EXPECT_THAT(sentences(scene), Contains(HasSubstr("paid back after 10 frames")));
    for (LabPoint& p : scene.series[0].points) p.beside_ms = 3;
    EXPECT_THAT(sentences(scene), Contains(HasSubstr("never paid back")));
}

TEST(LeftOut, IsToldWithWhatItSaves) {
    SceneReport scene = known_report();
    scene.series[0].left_out = LeftOutCost{"lod=4", 4, 5};
    EXPECT_THAT(sentences(scene), Contains(HasSubstr("quick at lod=4: with every stage run a frame "
                                                     "takes 5.00 ms, with what the scene does not "
                                                     "need left out 4.00 ms: -20.0 %")));
}

TEST(Yardsticks, AreFlipWhereThereIsFlip) {
    const Yardstick usual = usual_yardstick();
    const auto has_flip = std::any_of(metrics().begin(), metrics().end(),
                                      [](const Metric& m) { return m.name == "flip"; });
    EXPECT_EQ(usual.metric->name, has_flip ? "flip" : "rmse");
    EXPECT_EQ(usual.good_enough, 0.05);
}

}  // namespace
}  // namespace luch
