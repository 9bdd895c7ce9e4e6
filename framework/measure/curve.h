#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace luch {

/// A point of the plane of error against time.
struct CurvePoint {
    double time = 0;   ///< > 0, ms
    double error = 0;  ///< ≥ 0; 0: exact
};

/// What one technique reaches at its settings. Points whose time or error is not a number that is
/// asked for above are passed over by all functions below; the order of the others does not matter.
using Curve = std::vector<CurvePoint>;

/// Indices of the points that no other beats: none is at least as fast and at least as good, and
/// better in one of the two. By rising time; of equal points the first only.
std::vector<std::size_t> pareto_front(std::span<const CurvePoint> points);

/// The least error that a technique reaches within a time: at a setting that takes no longer, or
/// between two neighbouring settings, on the straight line between them in the log-log plane. (From
/// an exact setting there is no such line: it counts from its own time on.) Nothing when every
/// setting takes longer: there is no extrapolation.
std::optional<double> error_within(const Curve& curve, double time);

/// The least time in which it gets an error down to `error` (> 0), by the same lines. Nothing when
/// no setting does. A curve that begins below it begins with its own first time.
std::optional<double> time_for(const Curve& curve, double error);

/// 1/(variance · time), the mean squared error standing for the variance: Pharr, Jakob, Humphreys,
/// Physically Based Rendering (2023), 2.2. Of unbiased estimates only; per (unit of error)² and
/// second. Infinite where there is no error.
double efficiency(double rmse, double ms);

/// Over how many frames a preparation is paid back by frames that are faster: the least whole
/// number n with prepare + n·fast ≤ n·exact. 0 when there is nothing to pay; nothing when it is
/// never paid back.
std::optional<double> break_even_frames(double prepare_ms, double exact_ms, double fast_ms);

/// The error that is left however much is spent. A mean squared error is bias² + c·work^(2·slope),
/// a straight line over work^(2·slope), and the floor is where it meets 0: fitted by least squares
/// with the slope that is expected of the rest (< 0). With slope 0 (nothing is expected), or less
/// than three settings, the least error of all. Nothing without points.
std::optional<double> error_floor(std::span<const double> work, std::span<const double> errors,
                                  double slope);

}  // namespace luch
