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

/// The stages that were left out, how sure it is that this does no harm, and why.
std::string html_left_out(const SceneReport& scene);

}  // namespace luch
