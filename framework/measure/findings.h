#pragma once

#include "framework/measure/curve.h"
#include "framework/measure/report.h"
#include "framework/measure/statistics.h"

namespace luch {

// What the points of a report say when they are compared: by arithmetic only, nothing is run.

/// How error falls with work, against what is expected.
struct SlopeFinding {
    LineFit fit;
    double expected = 0;
    /// Off by more than 0.1: worth a warning.
    [[nodiscard]] bool differs() const;
};

/// Of a series' linear RMSE over its parameter. One sample a pixel is left out, which is the
/// pixel's centre and no random sample. Nothing when the technique expects nothing, or there are
/// not three settings with an error.
std::optional<SlopeFinding> slope_of(const LabSeries& series);

/// Of the mean of independent frames, over their number; −½ is expected of whatever is unbiased.
std::optional<SlopeFinding> passes_slope(const LabSeries& series);

/// Of a series by samples, which is unbiased: the best 1/(variance · time) of its settings, in
/// linear light. Nothing for others.
struct EfficiencyFinding {
    std::string setting;
    double value = 0;
};
std::optional<EfficiencyFinding> efficiency_of(const LabSeries& series);

/// Of the others: the error, as displayed, that no setting gets rid of. Nothing where none ran.
std::optional<double> floor_of(const LabSeries& series);

/// A point of one plane. Pointers are into the report.
struct PlanePoint {
    const LabSeries* series = nullptr;  ///< null: the baseline's own frame
    const LabPoint* point = nullptr;
    CurvePoint at;
    bool pareto = false;  ///< no other point of the plane beats it
};

/// All that has been measured against one truth.
struct ErrorPlane {
    std::string truth;
    std::vector<PlanePoint> points;
};
std::vector<ErrorPlane> planes_of(const SceneReport& scene, const Metric& metric);

/// What a technique reaches: an error within a time, or a time for an error.
struct Reached {
    std::string technique;
    double value = 0;
};

/// Within one time, the techniques by rising error. At least two.
struct EqualTime {
    double ms = 0;
    std::vector<Reached> errors;
};

/// For one error, the techniques by rising time; those that do not reach it are apart.
struct EqualError {
    std::vector<Reached> ms;
    std::vector<std::string> not_reached;
};

/// At the baseline's frame time times a power of 4 (1/16…64), where it makes the best a better one.
std::vector<EqualTime> at_equal_time(const ErrorPlane& plane, double baseline_ms);
EqualError at_equal_error(const ErrorPlane& plane, double error);

/// What is said of a scene beside the verdicts on its techniques: truths that are too rough for
/// what was measured, slopes, floors, efficiency, equal time and error, break-even frames, what
/// leaving out saves. A sentence each; a warning begins with "WARNING".
std::vector<std::string> findings(const SceneReport& scene, const Yardstick& yardstick);

}  // namespace luch
