#include "framework/measure/report_json.h"

#include "framework/measure/findings.h"

#include <cmath>

namespace luch {
namespace {

Json texts_json(const std::vector<std::string>& texts) {
    Json array = Json::array();
    for (const std::string& text : texts) array.push(text);
    return array;
}

Json machine_json(const Machine& machine) {
    return Json::object()
        .set("cpu", machine.cpu)
        .set("cores", machine.cores)
        .set("threads", machine.threads)
        .set("luch", machine.version)
        .set("compiler", machine.compiler)
        .set("date_utc", machine.date);
}

Json point_json(const SceneReport& scene, const LabSeries& series, const LabPoint& point) {
    Json json = Json::object();
    if (!series.parameter.empty()) json.set("value", point.value);
    json.set("ran", point.ran());
    if (!point.ran()) return json.set("not_run", point.not_run);
    return json.set("prepare_ms", point.prepare_ms)
        .set("frame_ms", point.frame_ms)
        .set("cpu_ms", point.cpu_ms)
        .set("baseline_beside_ms", point.beside_ms)
        .set("frames", point.frames)
        .set("speedup", scene.speedup(point))
        .set("rays", rays_json(point.counts))
        .set("all_rays", point.counts.all_rays())
        .set("object_tests", point.counts.object_tests)
        .set("shades", point.counts.shades)
        .set("fallbacks", point.counts.fallbacks)
        .set("cells", point.counts.cells)
        .set("bytes", point.bytes)
        .set("identical", point.identical)
        .set("errors", errors_json(point.errors))
        .set("linear_rmse", point.linear_rmse)
        .set("errors_to_converged", point.converged ? errors_json(*point.converged) : Json())
        .set("left_out", left_out_json(point.plan))
        .set("unwritten", texts_json(point.unwritten));
}

Json slope_json(const std::optional<SlopeFinding>& slope) {
    if (!slope) return {};
    return Json::object()
        .set("fitted", slope->fit.slope)
        .set("confidence_95", slope->fit.half_width)
        .set("expected", slope->expected)
        .set("points", slope->fit.points)
        .set("differs", slope->differs());
}

Json passes_json(const LabPasses& passes) {
    Json array = Json::array();
    for (std::size_t i = 0; i < passes.count.size(); ++i) {
        array.push(Json::object()
                       .set("frames", passes.count[i])
                       .set("linear_rmse", passes.linear_rmse[i]));
    }
    return array;
}

Json optional_json(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json series_json(const SceneReport& scene, const LabSeries& series) {
    Json points = Json::array();
    for (const LabPoint& point : series.points) points.push(point_json(scene, series, point));
    Json json = Json::object()
                    .set("technique", series.technique)
                    .set("title", series.title)
                    .set("parameter", series.parameter)
                    .set("truth", series.truth)
                    .set("points", std::move(points))
                    .set("slope", slope_json(slope_of(series)))
                    .set("floor_rmse", optional_json(floor_of(series)));
    if (const auto best = efficiency_of(series)) json.set("efficiency", best->value);
    if (!series.passes.count.empty()) {
        json.set("independent_frames", passes_json(series.passes));
        json.set("independent_slope", slope_json(passes_slope(series)));
    }
    if (!series.left_out) return json;
    return json.set("left_out_cost", Json::object()
                                         .set("setting", series.left_out->setting)
                                         .set("planned_ms", series.left_out->planned_ms)
                                         .set("no_skip_ms", series.left_out->forced_ms));
}

Json truth_json(const LabTruth& truth) {
    Json json = Json::object().set("name", truth.name).set("exact", truth.exact);
    if (truth.exact) return json;
    return json.set("samples", truth.samples)
        .set("standard_error", truth.standard_error)
        .set("from_cache", truth.from_cache);
}

Json reached_json(const std::vector<Reached>& all, std::string_view what) {
    Json array = Json::array();
    for (const Reached& one : all) {
        array.push(Json::object().set("technique", one.technique).set(what, one.value));
    }
    return array;
}

Json plane_json(const SceneReport& scene, const ErrorPlane& plane, const Yardstick& yardstick) {
    Json pareto = Json::array(), times = Json::array();
    for (const PlanePoint& point : plane.points) {
        if (!point.pareto) continue;
        const bool own = point.series == nullptr;
        pareto.push(Json::object()
                        .set("technique", own ? "baseline" : point.series->technique)
                        .set("setting", own ? "" : point.series->setting(*point.point))
                        .set("frame_ms", point.at.time)
                        .set("error", point.at.error));
    }
    for (const EqualTime& row : at_equal_time(plane, scene.baseline.frame_ms)) {
        times.push(
            Json::object().set("ms", row.ms).set("errors", reached_json(row.errors, "error")));
    }
    const EqualError equal = at_equal_error(plane, yardstick.good_enough);
    return Json::object()
        .set("truth", plane.truth)
        .set("metric", yardstick.metric->name)
        .set("pareto", std::move(pareto))
        .set("at_equal_time", std::move(times))
        .set("at_equal_error", Json::object()
                                   .set("error", yardstick.good_enough)
                                   .set("times", reached_json(equal.ms, "ms"))
                                   .set("not_reached", texts_json(equal.not_reached)));
}

Json scene_json(const SceneReport& scene, const Yardstick& yardstick) {
    Json all = Json::array(), truths = Json::array(), planes = Json::array();
    for (const LabSeries& series : scene.series) all.push(series_json(scene, series));
    for (const LabTruth& truth : scene.truths) truths.push(truth_json(truth));
    for (const ErrorPlane& plane : planes_of(scene, *yardstick.metric)) {
        planes.push(plane_json(scene, plane, yardstick));
    }
    return Json::object()
        .set("scene", scene.scene)
        .set("size", Json::array().push(scene.size.width).push(scene.size.height))
        .set("nodes", static_cast<std::uint64_t>(scene.nodes))
        .set("triangles", static_cast<std::uint64_t>(scene.triangles))
        .set("lights", static_cast<std::uint64_t>(scene.lights))
        .set("baseline_ms", scene.baseline.frame_ms)
        .set("baseline_rays", rays_json(scene.baseline.counts))
        .set("resumed", scene.resumed)
        .set("truths", std::move(truths))
        .set("converged_truth", scene.converged)
        .set("series", std::move(all))
        .set("planes", std::move(planes))
        .set("findings", texts_json(findings(scene, yardstick)));
}

}  // namespace

Json rays_json(const Counts& counts) {
    Json json = Json::object();
    for (std::size_t i = 0; i < ray_kind_names.size(); ++i) {
        json.set(ray_kind_names[i], counts.rays[i]);
    }
    return json;
}

Json errors_json(const Errors& errors, Json json) {
    for (const Metric& metric : metrics()) json.set(metric.name, errors.*metric.value);
    for (const Metric& metric : special_metrics()) {
        const double value = errors.*metric.value;
        if (!std::isnan(value)) json.set(metric.name, value);
    }
    json.set("flip_kind", errors.encoding == Encoding::linear ? "hdr" : "ldr");
    json.set("differing_pixels", errors.differing).set("non_finite", errors.non_finite.count);
    if (errors.max_at.x >= 0) {
        json.set("max_at", Json::array().push(errors.max_at.x).push(errors.max_at.y));
    }
    if (errors.non_finite.count > 0) {
        json.set("non_finite_at",
                 Json::array().push(errors.non_finite.first_x).push(errors.non_finite.first_y));
    }
    return json;
}

Json left_out_json(const Plan& plan) {
    Json array = Json::array();
    for (const Stage& stage : plan.stages) {
        if (stage.needed) continue;
        array.push(Json::object()
                       .set("stage", stage.name)
                       .set("exact", stage.kind == Stage::exact)
                       .set("kind", to_string(stage.kind))
                       .set("why", stage.why));
    }
    return array;
}

std::string report_json(const LabReport& report) {
    Json scenes = Json::array();
    for (const SceneReport& scene : report.scenes) scenes.push(scene_json(scene, report.yardstick));
    return Json::object()
        .set("version", LabReport::format_version)
        .set("command", report.command)
        .set("machine", machine_json(report.machine))
        .set("scenes", std::move(scenes))
        .text();
}

}  // namespace luch
