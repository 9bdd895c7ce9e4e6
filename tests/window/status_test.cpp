#include "framework/window/status.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

RenderResult result_of(double ms, std::uint64_t rays) {
    RenderResult result;
    result.request.techniques = {{"vista", nullptr}};
    Rendered rendered;
    rendered.outcome.frame_ms = {ms};
    rendered.outcome.counts.of(RayKind::primary) = rays;
    rendered.outcome.frame = Frame({320, 240});
    result.rendered.push_back(std::move(rendered));
    return result;
}

TEST(Status, NamesTechniqueTimeRaysAndResolution) {
    RenderResult result = result_of(12.34, 1'230'000);
    EXPECT_EQ(status_lines(result, "baseline").front(), "vista  12.3 ms  1.23 Mrays  320x240");
    result.request.divisor = 2;
    EXPECT_THAT(status_lines(result, "baseline").front(), HasSubstr("(1/2)"));
}

TEST(Status, SaysWhyATechniqueDoesNotApplyAndWhatIsShownInstead) {
    RenderResult result = result_of(5, 1000);
    result.rendered.front().declined = "there is no light";
    const auto lines = status_lines(result, "baseline");
    EXPECT_THAT(lines.front(), HasSubstr("baseline  5.0 ms"));
    EXPECT_THAT(lines, Contains("vista does not apply: there is no light; baseline is shown"));
}

TEST(Status, TellsWhatWasLeftOutWhatIsUnwrittenAndWhatIsNotFinite) {
    RenderResult result = result_of(5, 1000);
    Outcome& outcome = result.rendered.front().outcome;
    EXPECT_EQ(status_lines(result, "baseline").size(), 1u);
    outcome.plan.stages = {{"bump", false, Stage::exact, "no bump"},
                           {"blur", true, Stage::exact, "noise"},
                           {"haze", false, Stage::bounded, "thin", 0.5f}};
    outcome.unwritten = {"ssao.t1", "ssao.t2"};
    outcome.non_finite = {3, 7, 9};
    const auto lines = status_lines(result, "baseline");
    EXPECT_THAT(lines, Contains("left out: bump (exact), haze (bounded)"));
    EXPECT_THAT(lines, Contains(HasSubstr("ssao.t1 and ssao.t2")));
    EXPECT_THAT(lines, Contains(HasSubstr("3 pixels are not finite, the first at (7, 9)")));
}

TEST(Status, TimingGivesMedianRaysAndTheRatio) {
    RenderResult result = result_of(10, 500);
    result.rendered.front().outcome.frame_ms = {9, 10, 30};
    result.request.techniques.push_back({"baseline", nullptr});
    result.rendered.push_back(std::move(result_of(25, 2000).rendered.front()));
    const auto lines = timing_lines(result);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0], "timed: vista  10.00 ms (median of 3)  500 rays");
    EXPECT_EQ(lines[1], "timed: baseline  25.00 ms (median of 1)  2000 rays");
    EXPECT_EQ(lines[2], "timed: vista takes 0.40 of the time of baseline (2.50x)");
}

TEST(Status, TimingGivesNoRatioWhereTheTechniqueDoesNotApply) {
    RenderResult result = result_of(10, 500);
    result.rendered.front().declined = "there is no light";
    result.request.techniques.push_back({"baseline", nullptr});
    result.rendered.push_back(std::move(result_of(25, 2000).rendered.front()));
    const auto lines = timing_lines(result);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0], "timed: vista does not apply: there is no light");
}

TEST(Status, TheCamerasTextIsExact) {
    Camera camera;
    camera.position = {0.1, -2, 1.0 / 3};
    camera.yaw_deg = 12.5;
    camera.fov_deg = 60;
    EXPECT_EQ(camera_text(camera), "0.1,-2,0.3333333333333333,12.5,0,0,60");
    camera.projection = Projection::spherical;
    EXPECT_EQ(camera_text(camera), "0.1,-2,0.3333333333333333,12.5,0,0");
}

TEST(Status, PlanesAreNamedWithRangeAndUnit) {
    Frame frame({1, 1});
    frame.plane<float>("depth", PlaneKind::scalar, "units", 0, 12.5f);
    EXPECT_EQ(plane_line(frame.planes().front()), "plane depth [0, 12.5] units");
    frame.plane<std::uint32_t>("ids", PlaneKind::id);
    EXPECT_EQ(plane_line(frame.planes().back()), "plane ids");
}

TEST(Status, EveryKeyIsInTheHelp) {
    const auto help = help_lines();
    for (const char* key : {"W A S D", "arrows", "Shift", "PgUp", "Tab", "C,", "P\t", "M\t", "I\t",
                            "F5", "F12", "F1", "Esc", "mouse", "wheel", "Home"}) {
        EXPECT_THAT(help, Contains(HasSubstr(key)));
    }
}

}  // namespace
}  // namespace luch
