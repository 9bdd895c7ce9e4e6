#include "framework/measure/markup.h"
#include "framework/measure/ray_view.h"

#include <fmt/format.h>

namespace luch {
namespace {

/// In the order of RayKind.
constexpr std::array<std::string_view, ray_kind_names.size()> colours{
    "#ffd400", "#4fb3ff", "#ff5bd0", "#2fe0a0", "#ff8a2a", "#c59bff"};

/// "7: reflection, from 3, meets teapot".
std::string words_of(const RayLog& log, const Scene& scene, int index) {
    const LoggedRay& ray = log.rays()[static_cast<std::size_t>(index)];
    std::string words =
        fmt::format("{}: {}", index, ray_kind_names[static_cast<std::size_t>(ray.kind)]);
    if (ray.parent != LoggedRay::no_parent) words += fmt::format(", from {}", ray.parent);
    const std::string name = ray.node == no_node ? "" : scene.nodes[ray.node].name;
    if (ray.fate == LoggedRay::met) return words + ", meets " + name;
    if (ray.fate == LoggedRay::sky) return words + ", to the sky";
    return words + (ray.fate == LoggedRay::lit ? ", nothing between" : ", blocked by " + name);
}

/// A line over a darker, wider one, so that it is seen on white walls too.
std::string line(const RayLog& log, const Scene& scene, const RayStroke& stroke, double width) {
    const auto kind = static_cast<std::size_t>(log.rays()[std::size_t(stroke.ray)].kind);
    const std::string ends =
        fmt::format("x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"", stroke.from_px.x,
                    stroke.from_px.y, stroke.to_px.x, stroke.to_px.y);
    const std::string dashes =
        stroke.blocked ? fmt::format(" stroke-dasharray=\"{0:.2f} {0:.2f}\"", 2 * width) : "";
    return fmt::format(
        "<g opacity=\"{}\"><title>{}</title><line {} stroke=\"#000\" stroke-opacity=\"0.45\" "
        "stroke-width=\"{:.2f}\"{}/><line {} stroke=\"{}\" stroke-width=\"{:.2f}\"{}/></g>\n",
        stroke.hidden ? 0.28 : 1, escaped(words_of(log, scene, stroke.ray)), ends, 2 * width,
        dashes, ends, colours[kind], width, dashes);
}

std::string legend(const RayLog& log, double unit) {
    std::array<int, ray_kind_names.size()> counts{};
    int blocked = 0;
    for (const LoggedRay& ray : log.rays()) {
        ++counts[static_cast<std::size_t>(ray.kind)];
        blocked += ray.fate == LoggedRay::blocked ? 1 : 0;
    }
    std::string rows;
    double y = 1.5 * unit;
    const auto add = [&](std::string_view colour, bool dashed, const std::string& words) {
        rows += fmt::format(
            "<line x1=\"{0:.2f}\" x2=\"{1:.2f}\" y1=\"{2:.2f}\" y2=\"{2:.2f}\" stroke=\"{3}\" "
            "stroke-width=\"{4:.2f}\"{5}/><text x=\"{6:.2f}\" y=\"{7:.2f}\">{8}</text>\n",
            unit, 3 * unit, y, colour, unit / 4,
            dashed ? fmt::format(" stroke-dasharray=\"{0:.2f} {0:.2f}\"", unit / 2) : "",
            3.6 * unit, y + 0.36 * unit, words);
        y += 1.5 * unit;
    };
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        if (counts[kind] == 0) continue;
        add(colours[kind], false, fmt::format("{} {}", ray_kind_names[kind], counts[kind]));
    }
    if (blocked > 0) {
        add(colours[static_cast<std::size_t>(RayKind::shadow)], true,
            fmt::format("blocked {}", blocked));
    }
    return fmt::format(
        "<g font-family=\"sans-serif\" font-size=\"{:.2f}\" fill=\"#fff\"><rect x=\"{:.2f}\" "
        "y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" rx=\"{:.2f}\" fill=\"#000\" "
        "fill-opacity=\"0.6\"/>\n{}</g>\n",
        unit, 0.4 * unit, 0.4 * unit, 12 * unit, y - 0.6 * unit, 0.4 * unit, rows);
}

/// Later ones cover earlier ones: what is hidden first, the tree's root last.
std::vector<RayStroke> in_drawing_order(const RayLog& log, std::vector<RayStroke> strokes) {
    const auto rank = [&](const RayStroke& stroke) {
        const int depth = log.rays()[static_cast<std::size_t>(stroke.ray)].depth;
        return std::pair(stroke.hidden ? 0 : 1, -depth);
    };
    std::stable_sort(strokes.begin(), strokes.end(),
                     [&](const RayStroke& a, const RayStroke& b) { return rank(a) < rank(b); });
    return strokes;
}

}  // namespace

std::string ray_svg(const RayLog& log, const Scene& scene, const std::vector<RayStroke>& strokes,
                    Size size, const std::filesystem::path& png) {
    const double unit = std::max(size.height, size.width) / 45.0;
    std::string lines;
    for (const RayStroke& stroke : in_drawing_order(log, strokes)) {
        lines += line(log, scene, stroke, unit / 8);
    }
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\">\n<image href=\"{2}\" width=\"{0}\" height=\"{1}\"/>\n"
        "<g stroke-linecap=\"round\">\n{3}</g>\n{4}</svg>\n",
        size.width, size.height, png_data_uri(png), lines, legend(log, unit));
}

}  // namespace luch
