#pragma once

#include <limits>
#include <optional>
#include <span>

namespace luch {

/// t with P(−t < T < t) = 0.95 for Student's distribution of that many degrees of freedom (≥ 1):
/// 12.71, 4.30, 3.18…
double student_t_95(int degrees);

/// A straight line y = intercept + slope · x through points, by least squares.
struct LineFit {
    double slope = 0, intercept = 0;
    /// Of the slope's 95 % confidence interval, slope ± half_width; infinite with two points, of
    /// which nothing can be said.
    double half_width = std::numeric_limits<double>::infinity();
    int points = 0;
};

/// Nothing when there are not two different x. The spans are of one length.
std::optional<LineFit> fitted_line(std::span<const double> x, std::span<const double> y);

/// The same through (ln x, ln y): the slope is the power p of y ∝ xᵖ. Pairs of which one is not
/// positive and finite have no logarithm and are passed over.
std::optional<LineFit> fitted_power(std::span<const double> x, std::span<const double> y);

}  // namespace luch
