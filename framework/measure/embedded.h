#pragma once

#include <string_view>

// Files that are built into the program (luch_embed() in framework/measure/CMakeLists.txt).
namespace luch::embedded {

std::string_view uplot_script();  ///< uplot/uPlot.iife.min.js
std::string_view uplot_style();   ///< uplot/uPlot.min.css
std::string_view page_script();   ///< page/report.js

}  // namespace luch::embedded
