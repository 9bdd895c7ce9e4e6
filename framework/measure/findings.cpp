#include "framework/measure/findings.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace luch {
namespace {

std::string_view name_of(const PlanePoint& point) {
    return point.series == nullptr ? std::string_view("baseline") : point.series->technique;
}

/// The curves of a plane, by technique.
std::vector<std::pair<std::string, Curve>> curves_of(const ErrorPlane& plane) {
    std::vector<std::pair<std::string, Curve>> curves;
    for (const PlanePoint& point : plane.points) {
        const auto known = std::find_if(curves.begin(), curves.end(), [&](const auto& curve) {
            return curve.first == name_of(point);
        });
        if (known != curves.end()) {
            known->second.push_back(point.at);
        } else {
            curves.push_back({std::string(name_of(point)), {point.at}});
        }
    }
    return curves;
}

void sort_by_value(std::vector<Reached>& all) {
    std::stable_sort(all.begin(), all.end(),
                     [](const Reached& a, const Reached& b) { return a.value < b.value; });
}

void mark_pareto(ErrorPlane& plane) {
    Curve points;
    for (const PlanePoint& point : plane.points) points.push_back(point.at);
    for (const std::size_t i : pareto_front(points)) plane.points[i].pareto = true;
}

/// The errors of a point against a truth; null when it was not compared with it.
const Errors* errors_against(const SceneReport& scene, const LabSeries& series,
                             const LabPoint& point, const std::string& truth) {
    if (!point.ran() || point.errors.non_finite.count > 0) return nullptr;
    if (series.truth == truth) return &point.errors;
    // A technique with a truth of its own is not meant to be the baseline's picture.
    if (series.by_samples || truth != scene.converged || !point.converged) return nullptr;
    return &*point.converged;
}

}  // namespace

bool SlopeFinding::differs() const {
    return !(std::abs(fit.slope - expected) <= 0.1);
}

std::optional<SlopeFinding> slope_of(const LabSeries& series) {
    if (series.slope == 0) return std::nullopt;
    std::vector<double> values, errors;
    for (const LabPoint& point : series.points) {
        if (!point.ran() || (series.by_samples && point.value == 1)) continue;
        values.push_back(point.value);
        errors.push_back(point.linear_rmse);
    }
    const std::optional<LineFit> fit = fitted_power(values, errors);
    if (!fit || fit->points < 3) return std::nullopt;
    return SlopeFinding{*fit, series.slope};
}

std::optional<SlopeFinding> passes_slope(const LabSeries& series) {
    const auto fit = fitted_power(series.passes.count, series.passes.linear_rmse);
    if (!fit || fit->points < 3) return std::nullopt;
    return SlopeFinding{*fit, -0.5};
}

std::optional<EfficiencyFinding> efficiency_of(const LabSeries& series) {
    if (!series.by_samples) return std::nullopt;
    std::optional<EfficiencyFinding> best;
    for (const LabPoint& point : series.points) {
        if (!point.ran() || point.value == 1) continue;
        const double value = efficiency(point.linear_rmse, point.frame_ms);
        if (std::isfinite(value) && (!best || value > best->value)) {
            best = {series.setting(point), value};
        }
    }
    return best;
}

std::optional<double> floor_of(const LabSeries& series) {
    if (series.by_samples) return std::nullopt;
    std::vector<double> work, errors;
    for (const LabPoint& point : series.points) {
        if (!point.ran() || !std::isfinite(point.errors.rmse)) continue;
        work.push_back(point.value);
        errors.push_back(point.errors.rmse);
    }
    return error_floor(work, errors, series.slope);
}

std::vector<ErrorPlane> planes_of(const SceneReport& scene, const Metric& metric) {
    std::vector<ErrorPlane> planes;
    for (const LabTruth& truth : scene.truths) {
        ErrorPlane plane{truth.name, {}};
        for (const LabSeries& series : scene.series) {
            for (const LabPoint& point : series.points) {
                const Errors* errors = errors_against(scene, series, point, truth.name);
                if (errors == nullptr) continue;
                plane.points.push_back({&series, &point, {point.frame_ms, errors->*metric.value}});
            }
        }
        if ((truth.exact || truth.baseline) && !plane.points.empty()) {
            const double off = truth.baseline ? *truth.baseline.*metric.value : 0;
            plane.points.push_back({nullptr, &scene.baseline, {scene.baseline.frame_ms, off}});
        }
        mark_pareto(plane);
        if (!plane.points.empty()) planes.push_back(std::move(plane));
    }
    return planes;
}

std::vector<EqualTime> at_equal_time(const ErrorPlane& plane, double baseline_ms) {
    const auto curves = curves_of(plane);
    std::vector<EqualTime> rows;
    for (int power = -2; power <= 3; ++power) {
        EqualTime row{baseline_ms * std::pow(4.0, power), {}};
        for (const auto& [technique, curve] : curves) {
            const std::optional<double> error = error_within(curve, row.ms);
            if (error) row.errors.push_back({technique, *error});
        }
        if (row.errors.size() < 2) continue;
        sort_by_value(row.errors);
        const bool news = rows.empty() ||
                          rows.back().errors[0].technique != row.errors[0].technique ||
                          rows.back().errors[0].value != row.errors[0].value;
        if (news) rows.push_back(std::move(row));
    }
    return rows;
}

EqualError at_equal_error(const ErrorPlane& plane, double error) {
    EqualError reached;
    for (const auto& [technique, curve] : curves_of(plane)) {
        const std::optional<double> ms = time_for(curve, error);
        if (ms) {
            reached.ms.push_back({technique, *ms});
        } else {
            reached.not_reached.push_back(technique);
        }
    }
    sort_by_value(reached.ms);
    return reached;
}

}  // namespace luch
