#include "framework/measure/report_page.h"

#include "framework/measure/difference.h"
#include "framework/measure/markup.h"
#include "framework/measure/numbers.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch {
namespace {

std::string td(const std::string& text, std::string_view kind = "") {
    return kind.empty() ? fmt::format("<td>{}</td>", escaped(text))
                        : fmt::format("<td class=\"{}\">{}</td>", kind, escaped(text));
}

std::string badge(std::string_view kind, const std::string& text) {
    return fmt::format("<span class=\"badge {}\">{}</span>", kind, escaped(text));
}

std::string table_head(const std::vector<RayKind>& kinds) {
    std::string head =
        "<tr><th class=\"text\">technique</th><th class=\"text\">setting</th><th>prep<br>ms</th>"
        "<th>frame<br>ms</th><th>× faster</th><th>rays</th><th>of the<br>baseline’s</th>";
    for (const RayKind kind : kinds) head += fmt::format("<th>{}</th>", name_of(kind));
    head += "<th>object<br>tests</th><th>fall-<br>backs</th>";
    for (const Metric& metric : metrics()) {
        head +=
            fmt::format("<th title=\"{}\">{}</th>", escaped(metric.meaning), escaped(metric.label));
    }
    return head + "<th></th></tr>\n";
}

/// What must not be overlooked about a row.
std::string remark(const LabPoint& point) {
    std::string text;
    if (point.errors.non_finite.count > 0) {
        text += badge(
            "bad",
            fmt::format("{} not finite, first at ({}, {})", grouped(point.errors.non_finite.count),
                        point.errors.non_finite.first_x, point.errors.non_finite.first_y));
    }
    if (point.identical) text += badge("exact", "exact");
    for (const std::string& task : point.unwritten) {
        text += badge("bounded", task + " not written");
    }
    return text;
}

std::string table_row(const SceneReport& scene, const std::vector<RayKind>& kinds,
                      std::string_view row_kind, const std::string& technique,
                      const std::string& setting, const LabPoint& point) {
    std::string row =
        fmt::format("<tr class=\"{}\">", row_kind) + td(technique) + td(setting, "text");
    if (!point.ran()) {
        return row + fmt::format("<td class=\"why\" colspan=\"{}\">{}</td></tr>\n",
                                 8 + kinds.size() + metrics().size(), escaped(point.not_run));
    }
    const auto rays = static_cast<double>(point.counts.all_rays());
    row += td(three_digits(point.prepare_ms)) + td(three_digits(point.frame_ms)) +
           td(three_digits(scene.speedup(point)), "lead-number") +
           td(grouped(point.counts.all_rays())) +
           td(percent(rays, static_cast<double>(scene.baseline.counts.all_rays())));
    for (const RayKind kind : kinds) row += td(grouped(point.counts.of(kind)));
    row += td(grouped(point.counts.object_tests)) + td(grouped(point.counts.fallbacks));
    for (const Metric& metric : metrics()) row += td(shown(metric, point.errors));
    return row + "<td class=\"text\">" + remark(point) + "</td></tr>\n";
}

/// A picture with a caption. Touched, it fills the window; touched again, it returns.
std::string figure(const std::filesystem::path& file, const std::string& id,
                   const std::string& home, const std::string& title, const std::string& detail) {
    return fmt::format(
        "<figure id=\"{0}\"><a href=\"#{0}\"><img src=\"{1}\" alt=\"{2}\"></a>"
        "<a class=\"close\" href=\"#{3}\" aria-label=\"back\"></a>"
        "<figcaption><b>{2}</b> {4}</figcaption></figure>\n",
        id, png_data_uri(file), escaped(title), home, escaped(detail));
}

std::string legend() {
    constexpr int steps = 12;
    std::string stops = "#000 0 1%";
    for (int i = 0; i <= steps; ++i) {
        const Rgb c = legend_colour(static_cast<double>(i) / steps);
        stops += fmt::format(",rgb({},{},{}) {}%", byte_of(c.r), byte_of(c.g), byte_of(c.b),
                             1 + 99 * i / steps);
    }
    std::string ticks;
    for (const LegendTick& tick : error_legend()) {
        ticks +=
            fmt::format("<span style=\"left:{:.0f}%\">{}</span>", 100 * tick.position, tick.label);
    }
    return fmt::format(
        "<div class=\"legend\"><i style=\"background:linear-gradient(90deg,{})\"></i><div>{}</div>"
        "<p class=\"soft\">A pixel’s worst channel, in steps of 1/255 as displayed; black: equal; "
        "magenta: not finite.</p></div>\n",
        stops, ticks);
}

/// The settings to show: the best and, when it is another, the worst.
std::vector<std::pair<std::string, const LabPoint*>> shown_points(const LabSeries& series) {
    const LabPoint* best = series.best();
    const LabPoint* worst = series.worst();
    if (best == nullptr) return {};
    if (best == worst || series.parameter.empty()) return {{"", best}};
    return {{"best, ", best}, {"worst, ", worst}};
}

std::string left_out_rows(const std::string& technique, const Plan& plan) {
    std::string rows;
    for (const Stage& stage : plan.stages) {
        if (stage.needed) continue;
        const std::string kind(to_string(stage.kind));
        const std::string bound =
            stage.kind == Stage::bounded ? " ≤ " + three_digits(stage.bound) : "";
        rows += "<tr>" + td(technique) + td(stage.name, "text") + "<td class=\"text\">" +
                badge(kind, kind + bound) + "</td>" + td(stage.why, "why") + "</tr>\n";
    }
    return rows;
}

}  // namespace

std::string html_table(const SceneReport& scene) {
    const std::vector<RayKind> kinds = kinds_used(scene);
    std::string html = "<div class=\"wide\"><table>\n" + table_head(kinds);
    html += table_row(scene, kinds, "truth", "baseline", "pixel centres", scene.baseline);
    for (const LabSeries& series : scene.series) {
        std::string_view row_kind = "group";
        for (const LabPoint& point : series.points) {
            html +=
                table_row(scene, kinds, row_kind, series.technique, series.setting(point), point);
            row_kind = "";
        }
    }
    html += "</table></div>\n<p class=\"soft\">Errors as displayed (sRGB, white = 1). ";
    for (const LabSeries& series : scene.series) {
        html += fmt::format("{}{}: against {}. ", escaped(series.technique),
                            series.parameter.empty() ? "" : " by " + escaped(series.parameter),
                            escaped(series.truth));
    }
    return html + "</p>\n";
}

std::string html_pictures(const SceneReport& scene, std::string_view prefix) {
    const std::string home = fmt::format("{}-pictures", prefix);
    std::string html = fmt::format("<h3 id=\"{}\">Pictures</h3>\n<div class=\"pictures\">\n", home);
    int number = 0;
    bool differs = false;
    const auto add = [&](const std::filesystem::path& file, const std::string& title,
                         const std::string& detail) {
        if (file.empty()) return;
        html += figure(file, fmt::format("{}-picture-{}", prefix, ++number), home, title, detail);
    };
    add(scene.baseline.picture, "baseline", "at pixel centres");
    for (const LabSeries& series : scene.series) {
        if (series.by_samples) continue;
        for (const auto& [rank, point] : shown_points(series)) {
            const std::string detail = rank + series.setting(*point);
            add(point->picture, series.technique,
                point->identical ? detail + (detail.empty() ? "" : ": ") + "equal, bit for bit"
                                 : detail);
            add(point->difference, "where " + series.technique + " differs", detail);
            differs = differs || !point->difference.empty();
        }
    }
    if (number == 0) return "";
    return html + "</div>\n" + (differs ? legend() : "");
}

std::string html_left_out(const SceneReport& scene) {
    std::string rows = left_out_rows("baseline", scene.baseline.plan);
    for (const LabSeries& series : scene.series) {
        const LabPoint* best = series.best();
        if (!series.by_samples && best != nullptr) {
            rows += left_out_rows(series.technique, best->plan);
        }
    }
    if (rows.empty()) return "<h3>Left out</h3>\n<p>Nothing: this scene needs every stage.</p>\n";
    return "<h3>Left out, since this scene does not need it</h3>\n<div class=\"wide\"><table>\n"
           "<tr><th class=\"text\">technique</th><th class=\"text\">stage</th>"
           "<th class=\"text\">harm</th><th class=\"text\">why</th></tr>\n" +
           rows + "</table></div>\n";
}

}  // namespace luch
