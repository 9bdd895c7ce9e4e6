#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace luch {

struct PlotPoint {
    double x = 0;          ///< > 0
    double y = 0;          ///< ≥ 0; 0 is drawn on the floor row
    std::string label;     ///< beside the point, where there is room
    std::string detail;    ///< shown when the pointer rests on it
    bool flagged = false;  ///< drawn crossed out: the value is not to be trusted
    bool ringed = false;   ///< drawn with a ring around it: none beats it
};

struct PlotSeries {
    std::string name;
    std::vector<PlotPoint> points;
    bool dashed = false;
};

/// A vertical line.
struct PlotLine {
    double x = 0;
    std::string name;
};

/// A plot with logarithmic axes.
struct LogPlot {
    std::string title, x_label, y_label;
    std::string floor_label = "0";  ///< of the row for y = 0, below the axis of positive values
    std::vector<PlotSeries> series;
    std::optional<PlotLine> vertical;
};

/// A series' colour on a light and on a dark ground, "#0067a8".
struct Ink {
    const char* light;
    const char* dark;
};
/// The colours of series 0, 1…; after the last the first comes again.
std::span<const Ink> plot_inks();

/// The plot as one SVG element, for a file of its own or inside a page; follows the light or dark
/// scheme of whoever shows it. A point whose x or y is NaN, infinite or negative is left out.
std::string svg_of(const LogPlot& plot);

}  // namespace luch
