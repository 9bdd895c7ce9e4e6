#include "framework/measure/findings.h"
#include "framework/measure/numbers.h"
#include "framework/measure/plot.h"
#include "framework/measure/report_page.h"

#include <fmt/format.h>

namespace luch {
namespace {

/// Whether no other point of the same truth beats it.
bool is_pareto(const std::vector<ErrorPlane>& planes, const LabSeries& series,
               const LabPoint& point) {
    for (const ErrorPlane& plane : planes) {
        if (plane.truth != series.truth) continue;
        for (const PlanePoint& other : plane.points) {
            if (other.point == &point) return other.pareto;
        }
    }
    return false;
}

PlotPoint plot_point(const LabSeries& series, const LabPoint& point, bool pareto) {
    const std::string setting = series.setting(point);
    return {point.frame_ms,
            point.errors.rmse,
            series.parameter.empty() ? series.technique : exact_number(point.value),
            fmt::format("{} {}: RMSE {}, {} ms", series.technique, setting,
                        three_digits(point.errors.rmse), milliseconds(point.frame_ms)),
            point.errors.non_finite.count > 0,
            pareto};
}

}  // namespace

std::string report_svg(const SceneReport& scene) {
    LogPlot plot;
    plot.title = fmt::format("{}: error against time", scene.scene);
    plot.x_label =
        fmt::format("time of a frame of {} × {} pixels, ms", scene.size.width, scene.size.height);
    plot.y_label = "RMSE, as displayed (white = 1)";
    plot.floor_label = "0: exact";
    plot.vertical = PlotLine{scene.baseline.frame_ms,
                             fmt::format("baseline, {} ms", milliseconds(scene.baseline.frame_ms))};
    const std::vector<ErrorPlane> planes = planes_of(scene, find_metric("rmse"));
    for (const LabSeries* drawn : plotted_series(scene)) {
        const LabSeries& series = *drawn;
        PlotSeries curve;
        curve.name = series.technique;
        if (!series.parameter.empty()) curve.name += ", by " + series.parameter;
        if (series.by_samples) curve.name += ", against " + series.truth;
        curve.dashed = series.by_samples;
        for (const LabPoint& point : series.points) {
            if (!point.ran()) continue;
            curve.points.push_back(plot_point(series, point, is_pareto(planes, series, point)));
        }
        plot.series.push_back(std::move(curve));
    }
    return svg_of(plot);
}

}  // namespace luch
