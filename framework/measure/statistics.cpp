#include "framework/measure/statistics.h"

#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace luch {
namespace {

/// P(−t < T < t). Abramowitz & Stegun, Handbook of Mathematical Functions (1964), 26.7.3 for odd
/// and 26.7.4 for even degrees of freedom: a finite sum of powers of cos θ, tan θ = t/√degrees.
double student_inside(double t, int degrees) {
    const double theta = std::atan(t / std::sqrt(static_cast<double>(degrees)));
    const double cosine = std::cos(theta), sine = std::sin(theta);
    const bool odd = degrees % 2 == 1;
    double sum = 0, term = odd ? cosine : 1;
    for (int k = odd ? 1 : 0; k <= degrees - 2; k += 2) {
        sum += term;
        term *= cosine * cosine * (k + 1) / (k + 2);
    }
    return odd ? 2 / std::numbers::pi * (theta + sine * sum) : sine * sum;
}

bool has_logarithm(double value) {
    return value > 0 && std::isfinite(value);
}

}  // namespace

double student_t_95(int degrees) {
    assert(degrees >= 1);
    // From one degree of freedom on, t is below 12.8; 60 halvings are more than a double holds.
    double below = 0, above = 16;
    for (int i = 0; i < 60; ++i) {
        const double middle = (below + above) / 2;
        (student_inside(middle, degrees) < 0.95 ? below : above) = middle;
    }
    return above;
}

std::optional<LineFit> fitted_line(std::span<const double> x, std::span<const double> y) {
    assert(x.size() == y.size());
    const auto n = static_cast<double>(x.size());
    double mean_x = 0, mean_y = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / n;
        mean_y += y[i] / n;
    }
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    if (!(xx > 0)) return std::nullopt;
    LineFit fit{xy / xx, mean_y - xy / xx * mean_x};
    fit.points = static_cast<int>(x.size());
    if (fit.points < 3) return fit;
    double residual = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double off = y[i] - fit.intercept - fit.slope * x[i];
        residual += off * off;
    }
    fit.half_width = student_t_95(fit.points - 2) * std::sqrt(residual / (n - 2) / xx);
    return fit;
}

std::optional<LineFit> fitted_power(std::span<const double> x, std::span<const double> y) {
    std::vector<double> log_x, log_y;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!has_logarithm(x[i]) || !has_logarithm(y[i])) continue;
        log_x.push_back(std::log(x[i]));
        log_y.push_back(std::log(y[i]));
    }
    return fitted_line(log_x, log_y);
}

}  // namespace luch
