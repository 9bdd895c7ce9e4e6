#pragma once

#include "framework/measure/machine.h"
#include "framework/measure/metrics.h"
#include "framework/technique/plan.h"
#include "framework/trace/counts.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace luch {

/// One technique at one setting: a row of the table and a point of the curve.
struct LabPoint {
    double value = 0;     ///< of the series' parameter
    std::string not_run;  ///< why there is nothing below; empty when it ran
    Plan plan;
    double prepare_ms = 0;
    double frame_ms = 0;   ///< the median
    double cpu_ms = 0;     ///< processor time of all threads together, the median
    double beside_ms = 0;  ///< the baseline's median frame, made between these; 0: not measured
    int frames = 0;        ///< that the median is of
    Counts counts;
    std::uint64_t bytes = 0;
    std::vector<std::string> unwritten;  ///< tasks of a homework that fell back to the reference
    Errors errors;                       ///< as displayed, against the series' truth
    double linear_rmse = 0;              ///< against the same, in linear light
    std::optional<Errors> converged;     ///< as displayed, against SceneReport::converged
    bool identical = false;              ///< the linear frame equals the truth's, bit for bit
    std::filesystem::path picture, difference, flip_map;  ///< files; empty where none was written

    [[nodiscard]] bool ran() const { return not_run.empty(); }
};

/// What errors are measured against.
struct LabTruth {
    std::string name;  ///< "baseline, 256 samples a pixel in two halves"
    /// The frame that is approximated, itself: then nothing below has a meaning.
    bool exact = false;
    /// The baseline's own errors against it, when another technique made it; else it has none.
    std::optional<Errors> baseline = std::nullopt;
    int samples = 0;            ///< a pixel
    double standard_error = 0;  ///< its own, as displayed, the root over all channels
    bool from_cache = false;
    std::filesystem::path picture;  ///< a file; empty where none was written

    /// Whether it is good enough for errors as small as this RMSE, as displayed: its own standard
    /// error is at most a fifth.
    [[nodiscard]] bool good_to(double rmse) const { return exact || standard_error <= rmse / 5; }
};

/// What leaving out what the scene does not need saves, at a series' last setting that ran.
struct LeftOutCost {
    std::string setting;
    double planned_ms = 0;  ///< a frame with the stages left out
    double forced_ms = 0;   ///< made between those, with every stage run (--no-skip)
};

/// The error of the mean of independent frames of two samples a pixel, in linear light.
struct LabPasses {
    std::vector<double> count, linear_rmse;
};

/// A technique along its sweep, against one truth.
struct LabSeries {
    std::string technique;
    std::string title;      ///< one line
    std::string parameter;  ///< "" when the technique has no sweep: then there is one point
    std::string truth;      ///< what the errors are against: "baseline, 1 sample a pixel"
    std::vector<LabPoint> points;
    bool by_samples = false;  ///< by samples a pixel, against a truth of its own
    double slope = 0;         ///< that is expected of linear_rmse over the parameter; 0: none
    std::optional<LeftOutCost> left_out = std::nullopt;
    LabPasses passes = {};  ///< of a series by samples

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
    std::vector<LabTruth> truths;  ///< that the series name
    std::string converged;         ///< the truth of LabPoint::converged; empty: there is none
    int resumed = 0;               ///< measurements taken over from an interrupted run

    /// The truth of that name; nothing when it is not in the list.
    [[nodiscard]] const LabTruth* truth(std::string_view name) const;
    /// How many times faster than the baseline's frames of the same minute a point is.
    [[nodiscard]] double speedup(const LabPoint& point) const;
};

/// The metric that settings are compared by, and the error that counts as good enough: FLIP 0.05
/// where there is FLIP, else RMSE 0.05.
struct Yardstick {
    const Metric* metric = nullptr;
    double good_enough = 0.05;
};
Yardstick usual_yardstick();

/// A whole run of the lab.
struct LabReport {
    static constexpr int format_version = 2;  ///< of report.json and report.csv
    std::string command;                      ///< that makes it again
    Machine machine;
    std::vector<SceneReport> scenes;
    Yardstick yardstick = usual_yardstick();
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
