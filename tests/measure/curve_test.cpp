#include "framework/measure/curve.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>

namespace luch {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ParetoFront, KeepsWhatNoOtherBeats) {
    const Curve points{{4, 1}, {1, 8}, {2, 9}, {3, 2}, {5, 1}, {3, 2}, {9, 0}, {1, nan}};
    EXPECT_THAT(pareto_front(points), ::testing::ElementsAre(1, 3, 0, 6));
    EXPECT_TRUE(pareto_front({}).empty());
}

TEST(ErrorWithin, IsOnTheStraightLineOfTheLogLogPlane) {
    const Curve curve{{100, 0.01}, {1, 1}};  // error = 1/time
    EXPECT_NEAR(*error_within(curve, 10), 0.1, 1e-12);
    EXPECT_NEAR(*error_within(curve, 1), 1, 1e-12);
    EXPECT_NEAR(*error_within(curve, 100), 0.01, 1e-12);
}

TEST(ErrorWithin, DoesNotExtrapolate) {
    const Curve curve{{1, 1}, {100, 0.01}};
    EXPECT_FALSE(error_within(curve, 0.99));
    EXPECT_EQ(*error_within(curve, 1000), 0.01);  // the last setting takes less
    EXPECT_FALSE(error_within({}, 1));
}

TEST(ErrorWithin, TakesTheBestOfACurveThatRises) {
    const Curve curve{{1, 0.1}, {10, 0.5}};
    EXPECT_EQ(*error_within(curve, 10), 0.1);
}

TEST(ErrorWithin, CountsAnExactSettingFromItsOwnTimeOn) {
    const Curve curve{{1, 0.1}, {10, 0}};
    EXPECT_EQ(*error_within(curve, 9.9), 0.1);
    EXPECT_EQ(*error_within(curve, 10), 0);
}

TEST(TimeFor, IsTheInverseOfErrorWithin) {
    const Curve curve{{1, 1}, {100, 0.01}, {10'000, 0.009}};
    EXPECT_NEAR(*time_for(curve, 0.1), 10, 1e-9);
    EXPECT_NEAR(*error_within(curve, *time_for(curve, 0.0095)), 0.0095, 1e-12);
    EXPECT_FALSE(time_for(curve, 0.0089));
    EXPECT_EQ(*time_for(curve, 2), 1);  // it begins below
    EXPECT_EQ(*time_for({{1, 0.1}, {10, 0}}, 0.05), 10);
}

TEST(Efficiency, IsOneOverVarianceAndSeconds) {
    EXPECT_NEAR(efficiency(0.1, 500), 200, 1e-9);
    // Four times the samples: half of the error, four times the time.
    EXPECT_NEAR(efficiency(0.05, 2000), efficiency(0.1, 500), 1e-9);
}

TEST(BreakEven, IsTheFirstFrameThatPaysThePreparationBack) {
    EXPECT_EQ(*break_even_frames(100, 30, 20), 10);
    EXPECT_EQ(*break_even_frames(101, 30, 20), 11);
    EXPECT_EQ(*break_even_frames(0, 20, 30), 0);
    EXPECT_FALSE(break_even_frames(100, 20, 20));
    EXPECT_FALSE(break_even_frames(100, 20, 30));
}

TEST(ErrorFloor, IsTheBiasBelowTheNoise) {
    std::array<double, 4> work{1, 4, 16, 64}, errors{};
    for (std::size_t i = 0; i < 4; ++i) errors[i] = std::sqrt(0.02 * 0.02 + 0.25 / work[i]);
    EXPECT_NEAR(*error_floor(work, errors, -0.5), 0.02, 1e-9);
    EXPECT_EQ(*error_floor(work, errors, 0), errors[3]);
    for (std::size_t i = 0; i < 4; ++i) errors[i] = 0.5 / std::sqrt(work[i]);
    EXPECT_NEAR(*error_floor(work, errors, -0.5), 0, 1e-6);
    EXPECT_FALSE(error_floor({}, {}, -0.5));
}

}  // namespace
}  // namespace luch
