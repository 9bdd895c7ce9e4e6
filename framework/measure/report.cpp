#include "framework/measure/report.h"

#include "framework/base/files.h"
#include "framework/measure/numbers.h"

#include <fmt/format.h>

#include <set>

namespace luch {
namespace {

std::string accuracy(const SceneReport& scene, const LabSeries& series, const LabPoint& point) {
    if (point.errors.non_finite.count > 0) {
        return fmt::format("{} pixels are not finite", grouped(point.errors.non_finite.count));
    }
    if (point.identical) return "exact, bit for bit";
    if (point.errors.differing == 0) return "no displayed pixel differs";
    const LabTruth* const truth = scene.truth(series.truth);
    if (truth != nullptr && !truth->exact) {
        return fmt::format("RMSE {} against {}", three_digits(point.errors.rmse), truth->name);
    }
    const std::uint64_t off = point.errors.differing;
    return fmt::format("RMSE {}, {} ({}) off", three_digits(point.errors.rmse),
                       counted(off, "pixel"),
                       percent(static_cast<double>(off), static_cast<double>(scene.size.area())));
}

std::string pace(double speedup) {
    return speedup >= 1
               ? fmt::format("{} × faster than the baseline's frame", three_digits(speedup))
               : fmt::format("{} × slower than the baseline's frame", three_digits(1 / speedup));
}

std::string verdict(const SceneReport& scene, const LabSeries& series) {
    const LabPoint* best = series.best();
    if (best == nullptr) {
        return fmt::format("{}: not run, {}", series.technique,
                           series.points.empty() ? "no setting" : series.points.front().not_run);
    }
    const std::string setting = series.setting(*best);
    return fmt::format("{}{}: {}; {}, {} of its rays", series.technique,
                       setting.empty() ? "" : " at " + setting, accuracy(scene, series, *best),
                       pace(scene.speedup(*best)),
                       percent(static_cast<double>(best->counts.all_rays()),
                               static_cast<double>(scene.baseline.counts.all_rays())));
}

}  // namespace

std::string LabSeries::setting(const LabPoint& point) const {
    return parameter.empty() ? "" : parameter + "=" + exact_number(point.value);
}

const LabPoint* LabSeries::best() const {
    const LabPoint* best = nullptr;
    for (const LabPoint& point : points) {
        if (!point.ran()) continue;
        const bool better =
            best == nullptr || point.errors.rmse < best->errors.rmse ||
            (point.errors.rmse == best->errors.rmse && point.frame_ms < best->frame_ms);
        if (better) best = &point;
    }
    return best;
}

const LabPoint* LabSeries::worst() const {
    const LabPoint* worst = nullptr;
    for (const LabPoint& point : points) {
        if (point.ran() && (worst == nullptr || point.errors.rmse > worst->errors.rmse)) {
            worst = &point;
        }
    }
    return worst;
}

double SceneReport::speedup(const LabPoint& point) const {
    return (point.beside_ms > 0 ? point.beside_ms : baseline.frame_ms) / point.frame_ms;
}

const LabTruth* SceneReport::truth(std::string_view name) const {
    for (const LabTruth& truth : truths) {
        if (truth.name == name) return &truth;
    }
    return nullptr;
}

Yardstick usual_yardstick() {
    for (const Metric& metric : metrics()) {
        if (metric.name == "flip") return {&metric};
    }
    return {&find_metric("rmse")};
}

std::string_view name_of(RayKind kind) {
    return ray_kind_names[static_cast<std::size_t>(kind)];
}

std::vector<RayKind> kinds_used(const SceneReport& scene) {
    Counts all = scene.baseline.counts;
    for (const LabSeries& series : scene.series) {
        for (const LabPoint& point : series.points) all += point.counts;
    }
    std::vector<RayKind> kinds;
    for (std::size_t i = 0; i < ray_kind_names.size(); ++i) {
        if (all.rays[i] > 0) kinds.push_back(static_cast<RayKind>(i));
    }
    return kinds;
}

std::vector<std::string> unwritten_of(const LabSeries& series) {
    std::set<std::string> tasks;
    for (const LabPoint& point : series.points) {
        tasks.insert(point.unwritten.begin(), point.unwritten.end());
    }
    return {tasks.begin(), tasks.end()};
}

std::vector<std::string> verdicts(const SceneReport& scene) {
    std::vector<std::string> all;
    for (const LabSeries& series : scene.series) {
        if (!series.by_samples) all.push_back(verdict(scene, series));
    }
    return all;
}

void write_report(const LabReport& report, const std::filesystem::path& folder) {
    for (const SceneReport& scene : report.scenes) {
        write_text(folder / (scene.scene + ".svg"), report_svg(scene));
    }
    write_text(folder / "report.csv", report_csv(report));
    write_text(folder / "report.json", report_json(report));
    write_text(folder / "report.html", report_html(report));
}

}  // namespace luch
