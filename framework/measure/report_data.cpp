#include "framework/base/json.h"
#include "framework/measure/findings.h"
#include "framework/measure/numbers.h"
#include "framework/measure/plot.h"
#include "framework/measure/report_page.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch {
namespace {

const Errors& errors_of(const ErrorPlane& plane, const PlanePoint& point) {
    const bool own = point.series == nullptr || point.series->truth == plane.truth;
    return own ? point.point->errors : *point.point->converged;
}

Json point_json(const SceneReport& scene, const ErrorPlane& plane, const PlanePoint& point) {
    Json errors = Json::object();
    for (const Metric& metric : metrics()) {
        // A plot's vertical axis is an error: what rises with quality has no place on it.
        if (metric.higher_is_better) continue;
        errors.set(metric.name, errors_of(plane, point).*metric.value);
    }
    return Json::object()
        .set("ms", point.at.time)
        .set("setting",
             point.series == nullptr ? "at pixel centres" : point.series->setting(*point.point))
        .set("speedup", scene.speedup(*point.point))
        .set("errors", std::move(errors));
}

/// Series of one plane, in the order and with the colours of the static plot.
Json plane_json(const SceneReport& scene, const ErrorPlane& plane) {
    std::vector<const LabSeries*> order;
    for (const PlanePoint& point : plane.points) {
        if (std::find(order.begin(), order.end(), point.series) == order.end()) {
            order.push_back(point.series);
        }
    }
    Json all = Json::array();
    for (const LabSeries* series : order) {
        Json points = Json::array();
        for (const PlanePoint& point : plane.points) {
            if (point.series == series) points.push(point_json(scene, plane, point));
        }
        const auto drawn = plotted_series(scene);
        const auto ink = std::find(drawn.begin(), drawn.end(), series) - drawn.begin();
        all.push(Json::object()
                     .set("name", series == nullptr ? "baseline" : series->technique)
                     .set("by_samples", series != nullptr && series->by_samples)
                     .set("ink", static_cast<int>(ink))
                     .set("points", std::move(points)));
    }
    return Json::object().set("truth", plane.truth).set("series", std::move(all));
}

Json scene_json(const SceneReport& scene) {
    Json planes = Json::array();
    int first = 0, count = 0;
    for (const ErrorPlane& plane : planes_of(scene, find_metric("rmse"))) {
        planes.push(plane_json(scene, plane));
        if (plane.truth == scene.converged) first = count;
        ++count;
    }
    return Json::object()
        .set("baseline_ms", scene.baseline.frame_ms)
        .set("time_label", fmt::format("time of a frame of {} × {} pixels, ms", scene.size.width,
                                       scene.size.height))
        .set("first", first)  // the plane where all techniques and the line to beat are together
        .set("planes", std::move(planes));
}

}  // namespace

std::vector<const LabSeries*> plotted_series(const SceneReport& scene) {
    std::vector<const LabSeries*> all;
    for (const LabSeries& series : scene.series) {
        const auto ran = [](const LabPoint& point) { return point.ran(); };
        if (std::any_of(series.points.begin(), series.points.end(), ran)) all.push_back(&series);
    }
    return all;
}

std::string plot_data(const LabReport& report) {
    Json scenes = Json::array(), names = Json::array(), inks = Json::array();
    for (const SceneReport& scene : report.scenes) scenes.push(scene_json(scene));
    for (const Metric& metric : metrics()) {
        if (metric.higher_is_better) continue;
        names.push(Json::object().set("name", metric.name).set("label", metric.label));
    }
    for (const Ink& ink : plot_inks()) {
        inks.push(Json::array().push(ink.light).push(ink.dark));
    }
    const std::string json = Json::object()
                                 .set("inks", std::move(inks))
                                 .set("metrics", std::move(names))
                                 .set("yardstick", report.yardstick.metric->name)
                                 .set("scenes", std::move(scenes))
                                 .text();
    // In a page "<" could begin a tag that ends the script; in JSON it stands in strings only.
    std::string safe;
    for (const char c : json) safe += c == '<' ? "\\u003c" : std::string(1, c);
    return safe;
}

}  // namespace luch
