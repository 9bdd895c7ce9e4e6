#include "framework/measure/numbers.h"
#include "framework/measure/report.h"

#include <cmath>
#include <string_view>

namespace luch {
namespace {

/// A cell by RFC 4180: quoted where it must be, quotes doubled.
std::string cell(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

/// Empty for NaN, "inf" for infinity: what spreadsheets and pandas read.
std::string number(double value) {
    return std::isnan(value) ? "" : exact_number(value);
}

std::string joined(const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i > 0) line += ',';
        line += cell(cells[i]);
    }
    return line + "\n";
}

std::vector<std::string> header() {
    std::vector<std::string> names{"scene",  "width",   "height",  "technique",  "parameter",
                                   "value",  "not_run", "truth",   "prepare_ms", "frame_ms",
                                   "cpu_ms", "frames",  "speedup", "rays"};
    for (const std::string_view kind : ray_kind_names) names.push_back("rays_" + std::string(kind));
    names.insert(names.end(), {"object_tests", "shades", "fallbacks", "cells", "bytes"});
    for (const Metric& metric : metrics()) names.emplace_back(metric.name);
    names.insert(names.end(),
                 {"differing_pixels", "non_finite_pixels", "identical", "linear_rmse"});
    for (const Metric& metric : metrics()) {
        names.push_back("converged_" + std::string(metric.name));
    }
    return names;
}

std::vector<std::string> row(const SceneReport& scene, const LabSeries& series,
                             const LabPoint& point) {
    std::vector<std::string> cells{scene.scene,
                                   std::to_string(scene.size.width),
                                   std::to_string(scene.size.height),
                                   series.technique,
                                   series.parameter,
                                   series.parameter.empty() ? "" : number(point.value),
                                   point.not_run,
                                   series.truth};
    if (!point.ran()) {
        cells.resize(header().size());
        return cells;
    }
    cells.insert(cells.end(),
                 {number(point.prepare_ms), number(point.frame_ms), number(point.cpu_ms),
                  std::to_string(point.frames), number(scene.speedup(point)),
                  std::to_string(point.counts.all_rays())});
    for (const std::uint64_t rays : point.counts.rays) cells.push_back(std::to_string(rays));
    for (const std::uint64_t count : {point.counts.object_tests, point.counts.shades,
                                      point.counts.fallbacks, point.counts.cells, point.bytes}) {
        cells.push_back(std::to_string(count));
    }
    for (const Metric& metric : metrics()) cells.push_back(number(point.errors.*metric.value));
    cells.insert(cells.end(), {std::to_string(point.errors.differing),
                               std::to_string(point.errors.non_finite.count),
                               point.identical ? "1" : "0", number(point.linear_rmse)});
    for (const Metric& metric : metrics()) {
        cells.push_back(point.converged ? number((*point.converged).*metric.value) : "");
    }
    return cells;
}

}  // namespace

std::string report_csv(const LabReport& report) {
    std::string text = joined(header());
    for (const SceneReport& scene : report.scenes) {
        for (const LabSeries& series : scene.series) {
            for (const LabPoint& point : series.points) text += joined(row(scene, series, point));
        }
    }
    return text;
}

}  // namespace luch
