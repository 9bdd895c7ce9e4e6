#include "framework/measure/report_json.h"

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
        .set("left_out", left_out_json(point.plan))
        .set("unwritten", texts_json(point.unwritten));
}

Json scene_json(const SceneReport& scene) {
    Json all = Json::array();
    for (const LabSeries& series : scene.series) {
        Json points = Json::array();
        for (const LabPoint& point : series.points) points.push(point_json(scene, series, point));
        all.push(Json::object()
                     .set("technique", series.technique)
                     .set("title", series.title)
                     .set("parameter", series.parameter)
                     .set("truth", series.truth)
                     .set("points", std::move(points)));
    }
    return Json::object()
        .set("scene", scene.scene)
        .set("size", Json::array().push(scene.size.width).push(scene.size.height))
        .set("nodes", static_cast<std::uint64_t>(scene.nodes))
        .set("triangles", static_cast<std::uint64_t>(scene.triangles))
        .set("lights", static_cast<std::uint64_t>(scene.lights))
        .set("baseline_ms", scene.baseline.frame_ms)
        .set("baseline_rays", rays_json(scene.baseline.counts))
        .set("series", std::move(all));
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
    for (const SceneReport& scene : report.scenes) scenes.push(scene_json(scene));
    return Json::object()
        .set("version", LabReport::format_version)
        .set("command", report.command)
        .set("machine", machine_json(report.machine))
        .set("scenes", std::move(scenes))
        .text();
}

}  // namespace luch
