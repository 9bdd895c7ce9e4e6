#include "framework/measure/curve.h"

#include "framework/measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace luch {
namespace {

bool usable(const CurvePoint& point) {
    return point.time > 0 && std::isfinite(point.time) && point.error >= 0 &&
           std::isfinite(point.error);
}

/// The usable points by rising time.
Curve by_time(const Curve& curve) {
    Curve sorted;
    std::copy_if(curve.begin(), curve.end(), std::back_inserter(sorted), usable);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const CurvePoint& a, const CurvePoint& b) { return a.time < b.time; });
    return sorted;
}

/// y at x on the line through (x0, y0) and (x1, y1) in the log-log plane. All are positive.
double on_line(double x, double x0, double y0, double x1, double y1) {
    if (x1 == x0) return std::min(y0, y1);
    return y0 * std::pow(y1 / y0, std::log(x / x0) / std::log(x1 / x0));
}

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const CurvePoint> points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (usable(points[i])) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (points[a].time != points[b].time) return points[a].time < points[b].time;
        return points[a].error < points[b].error;
    });
    std::vector<std::size_t> front;
    double best = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (points[i].error >= best) continue;
        best = points[i].error;
        front.push_back(i);
    }
    return front;
}

std::optional<double> error_within(const Curve& curve, double time) {
    const Curve sorted = by_time(curve);
    std::optional<double> best;
    const auto take = [&](double error) { best = best ? std::min(*best, error) : error; };
    for (std::size_t i = 0; i < sorted.size() && sorted[i].time <= time; ++i) {
        take(sorted[i].error);
        if (i + 1 == sorted.size() || sorted[i + 1].time <= time) continue;
        const CurvePoint &a = sorted[i], &b = sorted[i + 1];
        if (a.error > 0 && b.error > 0) take(on_line(time, a.time, a.error, b.time, b.error));
    }
    return best;
}

std::optional<double> time_for(const Curve& curve, double error) {
    const Curve sorted = by_time(curve);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const CurvePoint& here = sorted[i];
        if (here.error > error) continue;
        if (i == 0 || here.error == 0) return here.time;
        const CurvePoint& before = sorted[i - 1];
        return on_line(error, before.error, before.time, here.error, here.time);
    }
    return std::nullopt;
}

double efficiency(double rmse, double ms) {
    return 1 / (rmse * rmse * ms * 1e-3);
}

std::optional<double> break_even_frames(double prepare_ms, double exact_ms, double fast_ms) {
    if (!(prepare_ms > 0)) return 0;
    if (!(fast_ms < exact_ms)) return std::nullopt;
    return std::ceil(prepare_ms / (exact_ms - fast_ms));
}

std::optional<double> error_floor(std::span<const double> work, std::span<const double> errors,
                                  double slope) {
    if (errors.empty()) return std::nullopt;
    const double least = *std::min_element(errors.begin(), errors.end());
    if (slope == 0 || errors.size() < 3) return least;
    std::vector<double> rest, squared;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        rest.push_back(std::pow(work[i], 2 * slope));
        squared.push_back(errors[i] * errors[i]);
    }
    const std::optional<LineFit> line = fitted_line(rest, squared);
    return line ? std::sqrt(std::clamp(line->intercept, 0.0, least * least)) : least;
}

}  // namespace luch
