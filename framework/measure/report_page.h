#pragma once

#include "framework/measure/report.h"

#include <string>
#include <string_view>

namespace luch {

// Parts of report.html.

/// The page's style sheet: for a projector, for paper, in light and in dark.
std::string page_style();

/// Every row: time and error.
std::string html_results(const SceneReport& scene);

/// Every row that ran: rays by kind and the other counts.
std::string html_costs(const SceneReport& scene);

/// The truth, each technique at its best and its worst setting, and where it differs. `prefix`
/// keeps the anchors of several scenes apart.
std::string html_pictures(const SceneReport& scene, std::string_view prefix);

/// What the comparison of points says: findings(), warnings first.
std::string html_findings(const SceneReport& scene, const Yardstick& yardstick);

/// The series that have a point to draw, in the order of their colours.
std::vector<const LabSeries*> plotted_series(const SceneReport& scene);

/// What page/report.js needs, as JSON that is safe inside a page.
std::string plot_data(const LabReport& report);

/// The page's own scripts and uPlot's style, with the data; all at the page's end.
std::string html_scripts(const LabReport& report);

/// The stages that were left out, how sure it is that this does no harm, and why.
std::string html_left_out(const SceneReport& scene);

}  // namespace luch
