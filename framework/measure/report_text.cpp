#include "framework/measure/numbers.h"
#include "framework/measure/report.h"
#include "framework/measure/table.h"

#include <fmt/format.h>

namespace luch {
namespace {

std::vector<std::string> header(const std::vector<RayKind>& kinds) {
    std::vector<std::string> titles{"technique", "setting", "prep ms", "frame ms",
                                    "× faster",  "rays",    "rays %"};
    for (const RayKind kind : kinds) titles.emplace_back(name_of(kind));
    titles.insert(titles.end(), {"object tests", "fallbacks"});
    for (const Metric& metric : metrics()) titles.emplace_back(metric.label);
    return titles;
}

std::vector<std::string> row(const SceneReport& scene, const std::vector<RayKind>& kinds,
                             const std::string& technique, const std::string& setting,
                             const LabPoint& point) {
    if (!point.ran()) return {technique, setting, point.not_run};
    std::vector<std::string> cells{technique,
                                   setting,
                                   milliseconds(point.prepare_ms),
                                   milliseconds(point.frame_ms),
                                   three_digits(scene.speedup(point)),
                                   grouped(point.counts.all_rays()),
                                   percent(static_cast<double>(point.counts.all_rays()),
                                           static_cast<double>(scene.baseline.counts.all_rays()))};
    for (const RayKind kind : kinds) cells.push_back(grouped(point.counts.of(kind)));
    cells.push_back(grouped(point.counts.object_tests));
    cells.push_back(grouped(point.counts.fallbacks));
    for (const Metric& metric : metrics()) cells.push_back(shown(metric, point.errors));
    return cells;
}

std::string warnings(const LabSeries& series) {
    std::string text;
    for (const LabPoint& point : series.points) {
        const NonFinite& bad = point.errors.non_finite;
        if (bad.count > 0) {
            text += fmt::format("NOT FINITE: {} {}: {} pixels, the first at ({}, {})\n",
                                series.technique, series.setting(point), bad.count, bad.first_x,
                                bad.first_y);
        }
    }
    const std::vector<std::string> tasks = unwritten_of(series);
    if (!tasks.empty()) {
        text += fmt::format("{}: still to be written, the reference stood in: {}\n",
                            series.technique, fmt::join(tasks, ", "));
    }
    return text;
}

}  // namespace

std::string report_text(const SceneReport& scene) {
    const std::vector<RayKind> kinds = kinds_used(scene);
    TextTable table(header(kinds));
    table.add(row(scene, kinds, "baseline", "centre", scene.baseline));
    std::string notes = "errors, as displayed (sRGB):\n";
    for (const LabSeries& series : scene.series) {
        for (const LabPoint& point : series.points) {
            table.add(row(scene, kinds, series.technique, series.setting(point), point));
        }
        notes +=
            fmt::format("  {}{} against {}\n", series.technique,
                        series.parameter.empty() ? "" : " by " + series.parameter, series.truth);
    }
    for (const LabSeries& series : scene.series) notes += warnings(series);
    return table.text() + notes;
}

}  // namespace luch
