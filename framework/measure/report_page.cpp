#include "framework/measure/report_page.h"

#include "framework/measure/difference.h"
#include "framework/measure/embedded.h"
#include "framework/measure/findings.h"
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

std::string rays_part(const SceneReport& scene, const LabPoint& point) {
    return percent(static_cast<double>(point.counts.all_rays()),
                   static_cast<double>(scene.baseline.counts.all_rays()));
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
    if (!point.unwritten.empty()) {
        text += badge("bounded", counted(point.unwritten.size(), "task") + " open");
    }
    return text;
}

/// A row of either table: who, with which setting, and what came out.
struct Row {
    std::string technique, setting;
    const LabPoint* point;
    std::string_view kind;  ///< of the <tr>
};

std::vector<Row> rows_of(const SceneReport& scene) {
    std::vector<Row> rows{{"baseline", "pixel centres", &scene.baseline, "truth"}};
    for (const LabSeries& series : scene.series) {
        for (const LabPoint& point : series.points) {
            const bool first = &point == &series.points.front();
            rows.push_back({series.technique, series.setting(point), &point, first ? "group" : ""});
        }
    }
    return rows;
}

std::string row_start(const Row& row) {
    return fmt::format("<tr class=\"{}\">", row.kind) + td(row.technique) + td(row.setting, "text");
}

std::string result_cells(const SceneReport& scene, const LabPoint& point) {
    if (!point.ran()) {
        return fmt::format("<td class=\"why\" colspan=\"{}\">{}</td>", 5 + metrics().size(),
                           escaped(point.not_run));
    }
    std::string cells = "<td class=\"text\">" + remark(point) + "</td>" +
                        td(milliseconds(point.prepare_ms)) + td(milliseconds(point.frame_ms)) +
                        td(three_digits(scene.speedup(point)), "lead-number") +
                        td(rays_part(scene, point));
    for (const Metric& metric : metrics()) cells += td(shown(metric, point.errors));
    return cells;
}

std::string cost_cells(const std::vector<RayKind>& kinds, const SceneReport& scene,
                       const LabPoint& point) {
    std::string cells = td(grouped(point.counts.all_rays())) + td(rays_part(scene, point));
    for (const RayKind kind : kinds) cells += td(grouped(point.counts.of(kind)));
    return cells + td(grouped(point.counts.object_tests)) + td(grouped(point.counts.shades)) +
           td(grouped(point.counts.fallbacks));
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
        "<p class=\"soft\">Where one differs: a pixel’s worst channel, in steps of 1/255 as "
        "displayed; black: equal; magenta: not finite. What is seen of it: FLIP, from black (0, "
        "alike) through violet and orange to light yellow (1); green: not finite.</p></div>\n",
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

/// Filled by page/report.js: two of the section's pictures under one slider.
std::string compare_box(std::string_view section) {
    return fmt::format(
        "<div class=\"compare\" data-section=\"{}\" data-right=\"1\" hidden><h3>Side by "
        "side</h3></div>\n",
        section);
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

std::string html_results(const SceneReport& scene) {
    std::string html =
        "<h3>Time and error</h3>\n<div class=\"wide\"><table>\n<tr><th>technique</th>"
        "<th class=\"text\">setting</th><th></th><th>prep, ms</th><th>frame, ms</th><th>× "
        "faster</th>"
        "<th>rays</th>";
    for (const Metric& metric : metrics()) {
        html +=
            fmt::format("<th title=\"{}\">{}</th>", escaped(metric.meaning), escaped(metric.label));
    }
    html += "</tr>\n";
    for (const Row& row : rows_of(scene)) {
        html += row_start(row) + result_cells(scene, *row.point) + "</tr>\n";
    }
    html += "</table></div>\n<p class=\"soft\">Errors as displayed (sRGB, white = 1). ";
    for (const LabSeries& series : scene.series) {
        html += fmt::format("{}{}: against {}. ", escaped(series.technique),
                            series.parameter.empty() ? "" : " by " + escaped(series.parameter),
                            escaped(series.truth));
    }
    return html + "</p>\n";
}

std::string html_costs(const SceneReport& scene) {
    const std::vector<RayKind> kinds = kinds_used(scene);
    std::string html =
        "<h3>Rays and tests of a frame</h3>\n<div class=\"wide\"><table>\n<tr><th>technique</th>"
        "<th class=\"text\">setting</th><th>rays</th><th>of the baseline’s</th>";
    for (const RayKind kind : kinds) html += fmt::format("<th>{}</th>", name_of(kind));
    html += "<th>object tests</th><th>shades</th><th>fallbacks</th></tr>\n";
    for (const Row& row : rows_of(scene)) {
        if (row.point->ran()) {
            html += row_start(row) + cost_cells(kinds, scene, *row.point) + "</tr>\n";
        }
    }
    return html + "</table></div>\n";
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
        const LabTruth* truth = scene.truth(series.truth);
        html += "</div>\n<div class=\"pictures\">\n";
        if (truth != nullptr) add(truth->picture, "truth", truth->name);
        for (const auto& [rank, point] : shown_points(series)) {
            const std::string detail = rank + series.setting(*point);
            add(point->picture, series.technique,
                point->identical ? detail + (detail.empty() ? "" : ": ") + "equal, bit for bit"
                                 : detail);
            add(point->difference, "where " + series.technique + " differs", detail);
            add(point->flip_map, "what is seen of it (FLIP)", detail);
            differs = differs || !point->difference.empty();
        }
    }
    if (number == 0) return "";
    return html + "</div>\n" + (differs ? legend() : "") + compare_box(prefix);
}

std::string html_findings(const SceneReport& scene, const Yardstick& yardstick) {
    std::string warnings, others;
    for (const std::string& sentence : findings(scene, yardstick)) {
        const bool warning = sentence.starts_with("WARNING");
        (warning ? warnings : others) +=
            fmt::format("<li{}>{}</li>\n", warning ? " class=\"warning\"" : "", escaped(sentence));
    }
    if (warnings.empty() && others.empty()) return "";
    return "<h3>What the points say together</h3>\n<ul class=\"findings\">\n" + warnings + others +
           "</ul>\n";
}

std::string html_scripts(const LabReport& report) {
    return fmt::format(
        "<style>{}</style>\n<script type=\"application/json\" id=\"lab-data\">{}</script>\n"
        "<script>{}</script>\n<script>{}</script>\n",
        embedded::uplot_style(), plot_data(report), embedded::uplot_script(),
        embedded::page_script());
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
