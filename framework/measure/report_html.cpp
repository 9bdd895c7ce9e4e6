#include "framework/measure/markup.h"
#include "framework/measure/numbers.h"
#include "framework/measure/report.h"
#include "framework/measure/report_page.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch {
namespace {

/// A technique's best point in two or three words.
std::string in_short(const SceneReport& scene, const std::string& technique) {
    for (const LabSeries& series : scene.series) {
        if (series.technique != technique || series.by_samples) continue;
        const LabPoint* best = series.best();
        if (best == nullptr) return "—";
        return fmt::format("{} × <span class=\"badge {}\">{}</span>",
                           three_digits(scene.speedup(*best)),
                           best->identical ? "exact" : "bounded",
                           best->identical ? "exact" : "RMSE " + three_digits(best->errors.rmse));
    }
    return "";
}

/// All scenes and techniques in one small table; nothing for a single scene.
std::string glance(const LabReport& report) {
    if (report.scenes.size() < 2) return "";
    std::vector<std::string> techniques;
    for (const SceneReport& scene : report.scenes) {
        for (const LabSeries& series : scene.series) {
            const bool known = std::find(techniques.begin(), techniques.end(), series.technique) !=
                               techniques.end();
            if (!known && !series.by_samples) techniques.push_back(series.technique);
        }
    }
    std::string html =
        "<section class=\"glance\"><h2>At a glance <small>how many times faster than the baseline, "
        "at the best setting</small></h2><div class=\"wide\"><table>\n<tr><th>scene</th>"
        "<th>baseline, ms</th>";
    for (const std::string& name : techniques) html += "<th>" + escaped(name) + "</th>";
    html += "</tr>\n";
    for (std::size_t i = 0; i < report.scenes.size(); ++i) {
        const SceneReport& scene = report.scenes[i];
        html += fmt::format("<tr><td><a href=\"#scene-{}\">{}</a></td><td>{}</td>", i + 1,
                            escaped(scene.scene), milliseconds(scene.baseline.frame_ms));
        for (const std::string& name : techniques) {
            html += "<td>" + in_short(scene, name) + "</td>";
        }
        html += "</tr>\n";
    }
    return html + "</table></div></section>\n";
}

std::string section(const SceneReport& scene, std::size_t number, const Yardstick& yardstick) {
    const std::string id = fmt::format("scene-{}", number);
    std::string html = fmt::format(
        "<section id=\"{}\">\n<h2>{}<small>{} × {} pixels, {}, {}, {}</small></h2>\n<ul "
        "class=\"verdicts\">\n",
        id, escaped(scene.scene), scene.size.width, scene.size.height, counted(scene.nodes, "node"),
        counted(scene.triangles, "triangle"), counted(scene.lights, "light"));
    for (const std::string& sentence : verdicts(scene)) {
        html += "<li>" + escaped(sentence) + "</li>\n";
    }
    return html + "</ul>\n<figure class=\"plot\">" + report_svg(scene) + "</figure>\n" +
           html_findings(scene, yardstick) + html_results(scene) + html_costs(scene) +
           html_pictures(scene, id) + html_left_out(scene) + "</section>\n";
}

std::string facts(const LabReport& report) {
    const Machine& machine = report.machine;
    const auto fact = [](std::string_view name, const std::string& value) {
        return fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, value);
    };
    return "<section><h2>How this was measured</h2>\n<dl class=\"facts\">\n" +
           fact("again", "<code>" + escaped(report.command) + "</code>") +
           fact("processor", escaped(machine.cpu)) +
           fact("threads", fmt::format("{} of {}", machine.threads, machine.cores)) +
           fact("program",
                fmt::format("luch {}, {}", escaped(machine.version), escaped(machine.compiler))) +
           fact("date", escaped(machine.date) + " UTC") +
           "</dl>\n<p class=\"soft\">A time is the median of several frames after a warm-up and "
           "holds for this machine only; preparation is apart. Counts of rays and tests are the "
           "same "
           "on every machine. The dotted line of a plot is the baseline at one sample a pixel; a "
           "dashed curve has a truth of its own, named in its legend, and is not to be compared in "
           "error with the solid ones; where the plot lets one choose, all curves shown are "
           "against "
           "the truth that is chosen. “× faster” compares with frames of the baseline that were "
           "made "
           "between the technique’s own.</p></section>\n";
}

}  // namespace

std::string report_html(const LabReport& report) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>luch lab: error against time</title>\n" +
        page_style() +
        "</head>\n<body>\n<header><h1>Error against time</h1>\n<p class=\"lead\">Each technique "
        "beside the classic ray tracer, on the same scene, in the same minute.</p></header>\n"
        "<main>\n";
    html += glance(report);
    for (std::size_t i = 0; i < report.scenes.size(); ++i) {
        html += section(report.scenes[i], i + 1, report.yardstick);
    }
    return html + facts(report) + "</main>\n" + html_scripts(report) + "</body>\n</html>\n";
}

}  // namespace luch
