#include "framework/measure/measurement.h"

#include "tests/measure/toys.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>

#include <limits>

namespace luch {
namespace {

using testing::noisy;
using testing::off;

/// Frames of which technique, in the order in which they were made.
std::string order;

template <char Name>
class Logged final : public testing::Off {
 public:
    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        order += Name;
        Off::render(scene, shot, frame, context);
    }
};

TEST(Measured, MakesTheOthersFramesBetweenItsOwn) {
    const testing::OwnStudio own(testing::one_triangle(), 1);
    const Studio studio = own.studio();
    const Shot shot = shot_of(own.scene());
    const Budget budget;
    const TechniqueInfo a{"a", "", "", testing::create<Logged<'a'>>, {}};
    const TechniqueInfo b{"b", "", "", testing::create<Logged<'b'>>, {}};
    const Subject beside{&b};
    order.clear();
    const Measurement measurement = measured({&a}, &beside, {studio, shot, budget}, {1, 6});
    EXPECT_EQ(order, "aaabbbaaabbbaaabbb");  // a warm-up and two frames a round
    EXPECT_EQ(measurement.outcome.frame_ms.size(), 6u);
    EXPECT_EQ(measurement.outcome.cpu_ms.size(), 6u);
    EXPECT_EQ(measurement.beside_ms.size(), 6u);
    EXPECT_EQ(measurement.beside(), median(measurement.beside_ms));
}

TEST(Measured, RunsEveryStageWhereNothingIsToBeSkipped) {
    const testing::OwnStudio own(testing::one_triangle(), 1);
    const Studio studio = own.studio();
    const Shot shot = shot_of(own.scene());
    const Budget budget;
    const Workbench bench{studio, shot, budget};
    EXPECT_FALSE(measured({&noisy}, nullptr, bench, {0, 1}).outcome.plan.stages[0].needed);
    EXPECT_TRUE(
        measured({&noisy, "", 1, false}, nullptr, bench, {0, 1}).outcome.plan.stages[0].needed);
}

TEST(Measured, IsTheSameAfterAWayThroughBytes) {
    Measurement measurement;
    Outcome& outcome = measurement.outcome;
    measurement.beside_ms = {1.5, 0.1};
    outcome.plan = {true, "why", {{"a", false, Stage::bounded, "b \"c\"", 0.5f}}};
    outcome.prepare_ms = 0.3;
    outcome.frame_ms = {1.0 / 3, 2};
    outcome.cpu_ms = {7};
    outcome.threads = 3;
    outcome.counts.of(RayKind::gi) = 123'456'789'012;
    outcome.counts.fallbacks = 4;
    outcome.bytes = 5;
    outcome.unwritten = {"vista.t2"};
    outcome.frame = Frame({2, 1});
    outcome.frame.colour(1, 0) = {0.1f, std::numeric_limits<float>::quiet_NaN(), -1};
    const std::string bytes = bytes_of(measurement);
    const std::optional<Measurement> read = measurement_of(bytes);
    ASSERT_TRUE(read);
    EXPECT_EQ(bytes_of(*read), bytes);
    EXPECT_EQ(read->outcome.frame_ms, outcome.frame_ms);
    EXPECT_EQ(read->outcome.plan.stages.at(0).why, "b \"c\"");
    EXPECT_FALSE(read->outcome.plan.stages.at(0).needed);
    EXPECT_EQ(read->outcome.counts.of(RayKind::gi), 123'456'789'012u);
    EXPECT_EQ(read->outcome.non_finite.count, 1u);
    EXPECT_EQ(read->outcome.unwritten, outcome.unwritten);
}

TEST(Measured, IsNothingWhenTheBytesAreNone) {
    Measurement measurement;
    measurement.outcome.frame = Frame({2, 1});
    const std::string bytes = bytes_of(measurement);
    ASSERT_TRUE(measurement_of(bytes));
    for (const std::size_t length : {std::size_t{0}, std::size_t{5}, bytes.size() - 1}) {
        EXPECT_FALSE(measurement_of(bytes.substr(0, length))) << length;
    }
    EXPECT_FALSE(measurement_of("2\n{}99999999 99999999\n"));
    EXPECT_FALSE(image_of("-1 1\n"));
}

}  // namespace
}  // namespace luch
