#include "framework/measure/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace luch {
namespace {

TEST(Student, HasThePublishedQuantiles) {
    // NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.2, two-sided 95 %.
    EXPECT_NEAR(student_t_95(1), 12.706, 5e-4);
    EXPECT_NEAR(student_t_95(2), 4.303, 5e-4);
    EXPECT_NEAR(student_t_95(3), 3.182, 5e-4);
    EXPECT_NEAR(student_t_95(4), 2.776, 5e-4);
    EXPECT_NEAR(student_t_95(10), 2.228, 5e-4);
    EXPECT_NEAR(student_t_95(100), 1.984, 5e-4);
}

TEST(FittedLine, GoesThroughPointsOnALine) {
    const auto fit = fitted_line(std::array{1.0, 2.0, 5.0}, std::array{1.0, 3.0, 9.0});
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->slope, 2, 1e-12);
    EXPECT_NEAR(fit->intercept, -1, 1e-12);
    EXPECT_NEAR(fit->half_width, 0, 1e-6);
    EXPECT_EQ(fit->points, 3);
}

TEST(FittedLine, HasTheIntervalOfTheTextbooks) {
    // y = 2x + 0.1 · {1, −2, 0, 2, −1}: the residuals are orthogonal to 1 and to x, Σ(x−x̄)² = 10.
    const std::array x{1.0, 2.0, 3.0, 4.0, 5.0};
    const std::array y{2.1, 3.8, 6.0, 8.2, 9.9};
    const auto fit = fitted_line(x, y);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->slope, 2, 1e-12);
    EXPECT_NEAR(fit->half_width, 3.1824 * std::sqrt(0.10 / 3 / 10), 1e-4);
}

TEST(FittedLine, SaysNothingWhereThereIsNothingToSay) {
    EXPECT_FALSE(fitted_line({}, {}));
    EXPECT_FALSE(fitted_line(std::array{1.0}, std::array{1.0}));
    EXPECT_FALSE(fitted_line(std::array{1.0, 1.0}, std::array{1.0, 2.0}));
    const auto two = fitted_line(std::array{1.0, 2.0}, std::array{1.0, 2.0});
    ASSERT_TRUE(two);
    EXPECT_TRUE(std::isinf(two->half_width));
}

TEST(FittedPower, FindsThePowerAndPassesOverWhatHasNoLogarithm) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const std::array x{1.0, 4.0, 16.0, 2.0, 0.0, 8.0};
    const std::array y{3.0, 1.5, 0.75, 0.0, 1.0, inf};
    const auto fit = fitted_power(x, y);
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->points, 3);
    EXPECT_NEAR(fit->slope, -0.5, 1e-12);
    EXPECT_NEAR(std::exp(fit->intercept), 3, 1e-12);
}

}  // namespace
}  // namespace luch
