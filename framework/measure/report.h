#pragma once

#include "framework/measure/machine.h"
#include "framework/measure/metrics.h"
#include "framework/technique/plan.h"
#include "framework/trace/counts.h"

#include <filesystem>
#include <string>
#include <vector>

namespace luch {

/// One technique at one setting: a row of the table and a point of the curve.
struct LabPoint {
    double value = 0;     ///< of the series' parameter
    std::string not_run;  ///< why there is nothing below; empty when it ran
    Plan plan;
    double prepare_ms = 0;
    double frame_ms = 0;  ///< the median
    int frames = 0;       ///< that the median is of
    Counts counts;
    std::uint64_t bytes = 0;
    std::vector<std::string> unwritten;  ///< tasks of a homework that fell back to the reference
    Errors errors;                       ///< as displayed
    bool identical = false;              ///< the linear frame equals the truth's, bit for bit
    std::filesystem::path picture, difference;  ///< files; empty where none was written

    [[nodiscard]] bool ran() const { return not_run.empty(); }
};

/// A technique along its sweep, against one truth.
struct LabSeries {
    std::string technique;
    std::string title;      ///< one line
    std::string parameter;  ///< "" when the technique has no sweep: then there is one point
    std::string truth;      ///< what the errors are against: "baseline, 1 sample a pixel"
    std::vector<LabPoint> points;
    bool by_samples = false;  ///< the baseline by samples a pixel, against a truth of its own

    [[nodiscard]] std::string setting(
        const LabPoint& point) const;  ///< "lod=4", "" without a sweep
    [[nodiscard]] const LabPoint* best()
        const;  ///< least RMSE of those that ran, the fastest of equals
    [[nodiscard]] const LabPoint* worst() const;  ///< largest RMSE of those that ran
};

/// All that was measured on one scene.
struct SceneReport {
    std::string scene;
    Size size;
    std::size_t nodes = 0, triangles = 0, lights = 0;
    LabPoint
        baseline;  ///< at 1 sample a pixel: the truth and the time that others are compared with
    std::vector<LabSeries> series;

    /// How many times faster than the baseline a point is.
    [[nodiscard]] double speedup(const LabPoint& point) const;
};

/// A whole run of the lab.
struct LabReport {
    static constexpr int format_version = 1;  ///< of report.json and report.csv
    std::string command;                      ///< that makes it again
    Machine machine;
    std::vector<SceneReport> scenes;
};

std::string_view name_of(RayKind kind);

/// The kinds of rays that anything on this scene shot, so that tables need no empty columns.
std::vector<RayKind> kinds_used(const SceneReport& scene);

/// The tasks of a homework that fell back to the reference at any setting, each once, sorted.
std::vector<std::string> unwritten_of(const LabSeries& series);

/// What the series on a scene have to show, in plain words, one sentence a technique.
std::vector<std::string> verdicts(const SceneReport& scene);

std::string report_text(const SceneReport& scene);
std::string report_csv(const LabReport& report);
std::string report_json(const LabReport& report);
/// Error against time on logarithmic axes, as SVG.
std::string report_svg(const SceneReport& scene);
/// One page that opens offline: plots, tables and pictures are all in it. Reads the points'
/// pictures.
std::string report_html(const LabReport& report);

/// Writes report.csv, report.json, report.html and <scene>.svg into a folder. Throws Error when it
/// cannot.
void write_report(const LabReport& report, const std::filesystem::path& folder);

}  // namespace luch
