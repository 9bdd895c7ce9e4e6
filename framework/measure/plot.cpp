#include "framework/measure/plot.h"

#include "framework/measure/log_axis.h"
#include "framework/measure/markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace luch {
namespace {

constexpr double width = 960, left = 96, right = 936;
constexpr double top = 52, bottom = 400;       // of the values above 0
constexpr double floor_y = 432, axis_y = 456;  // the row for 0, and the x axis
constexpr double legend_y = 540, legend_step = 26;

// Told apart by people with any of the usual colour blindnesses (Okabe & Ito, 2008), darkened or
// lightened for the background; the marker's shape says it again.
constexpr std::array<Ink, 6> inks{Ink{"#0067a8", "#5cb8f0"}, Ink{"#c24e00", "#ff9a52"},
                                  Ink{"#00805c", "#3fd0a4"}, Ink{"#a8457f", "#ee9ccb"},
                                  Ink{"#8a6d00", "#ecc84a"}, Ink{"#5b5bb5", "#b0b0ff"}};

bool drawable(const PlotPoint& point) {
    return point.x > 0 && std::isfinite(point.x) && point.y >= 0 && std::isfinite(point.y);
}

/// A rectangle on the page that something written takes up.
struct Room {
    double x0, y0, x1, y1;
    [[nodiscard]] bool meets(const Room& other) const {
        return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
    }
};

/// About as wide as text of that many characters is; there is no font to ask.
double text_width(const std::string& text, double size) {
    const auto letters = std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    });
    return static_cast<double>(letters) * size * 0.56;
}

class Drawing {
 public:
    explicit Drawing(const LogPlot& plot);
    std::string text();

 private:
    void frame();
    void x_ticks();
    void y_ticks();
    void vertical_line();
    void lines(const PlotSeries& series, std::size_t index);
    void markers(const PlotSeries& series, std::size_t index);
    void marker(std::size_t index, double x, double y, const char* kind);
    void label(const PlotPoint& point, double x, double y);
    void legend();
    std::string style() const;

    template <class... Values>
    void put(fmt::format_string<Values...> form, Values&&... values) {
        fmt::format_to(std::back_inserter(body_), form, std::forward<Values>(values)...);
        body_ += '\n';
    }
    [[nodiscard]] double y_of(double value) const { return value > 0 ? y_.at(value) : floor_y; }
    [[nodiscard]] std::vector<double> values(double PlotPoint::*member) const;

    const LogPlot* plot_;
    LogAxis x_, y_;
    std::vector<Room> taken_;
    std::string body_;
    double height_ = legend_y;
};

std::vector<double> Drawing::values(double PlotPoint::*member) const {
    std::vector<double> all;
    for (const PlotSeries& series : plot_->series) {
        for (const PlotPoint& point : series.points) {
            if (drawable(point)) all.push_back(point.*member);
        }
    }
    if (member == &PlotPoint::x && plot_->vertical) all.push_back(plot_->vertical->x);
    return all;
}

Drawing::Drawing(const LogPlot& plot)
    : plot_(&plot),
      x_(values(&PlotPoint::x), left + 16, right - 16),
      y_(values(&PlotPoint::y), bottom, top) {}

void Drawing::frame() {
    put(R"(<text class="title" x="{}" y="28">{}</text>)", left, escaped(plot_->title));
    put(R"(<rect class="area" x="{}" y="{}" width="{}" height="{}"/>)", left, top, right - left,
        axis_y - top);
    put(R"(<rect class="floor" x="{}" y="{}" width="{}" height="{}"/>)", left, bottom + 8,
        right - left, axis_y - bottom - 8);
    put(R"(<text class="tick end" x="{}" y="{}">{}</text>)", left - 10, floor_y + 5,
        escaped(plot_->floor_label));
    put(R"(<text class="axis middle" x="{}" y="{}">{}</text>)", (left + right) / 2, axis_y + 48,
        escaped(plot_->x_label));
    put(R"svg(<text class="axis middle" transform="translate(22 {}) rotate(-90)">{}</text>)svg",
        (top + bottom) / 2, escaped(plot_->y_label));
    put(R"(<text class="hint" x="{}" y="{}">↙ better</text>)", left + 10, bottom - 8);
    taken_.push_back({left, bottom - 26, left + 80, bottom});
}

void Drawing::x_ticks() {
    for (const LogAxis::Tick& tick : x_.ticks()) {
        const double x = x_.at(tick.value);
        if (!tick.label.empty()) {
            put(R"(<line class="{}" x1="{:.1f}" y1="{}" x2="{:.1f}" y2="{}"/>)",
                tick.decade ? "grid decade" : "grid", x, top, x, axis_y);
            put(R"(<text class="tick middle" x="{:.1f}" y="{}">{}</text>)", x, axis_y + 24,
                tick.label);
        }
        put(R"(<line class="mark" x1="{:.1f}" y1="{}" x2="{:.1f}" y2="{}"/>)", x, axis_y, x,
            axis_y + (tick.decade ? 8 : 5));
    }
}

void Drawing::y_ticks() {
    for (const LogAxis::Tick& tick : y_.ticks()) {
        const double y = y_.at(tick.value);
        if (!tick.label.empty()) {
            put(R"(<line class="{}" x1="{}" y1="{:.1f}" x2="{}" y2="{:.1f}"/>)",
                tick.decade ? "grid decade" : "grid", left, y, right, y);
            put(R"(<text class="tick end" x="{}" y="{:.1f}">{}</text>)", left - 10, y + 5,
                tick.label);
        }
        put(R"(<line class="mark" x1="{}" y1="{:.1f}" x2="{}" y2="{:.1f}"/>)",
            left - (tick.decade ? 8 : 5), y, left, y);
    }
}

void Drawing::vertical_line() {
    if (!plot_->vertical || !(plot_->vertical->x > 0)) return;
    const double x = x_.at(plot_->vertical->x);
    const double wide = text_width(plot_->vertical->name, 14);
    const bool to_left = x + wide + 14 > right;
    const double at = to_left ? x - 8 : x + 8;
    put(R"(<line class="baseline" x1="{:.1f}" y1="{}" x2="{:.1f}" y2="{}"/>)", x, top, x, axis_y);
    put(R"(<text class="note{}" x="{:.1f}" y="{}">{}</text>)", to_left ? " end" : "", at, top + 20,
        escaped(plot_->vertical->name));
    taken_.push_back({x - 3, top, x + 3, axis_y});
    taken_.push_back({to_left ? at - wide : at, top + 4, to_left ? at : at + wide, top + 26});
}

void Drawing::lines(const PlotSeries& series, std::size_t index) {
    std::string path;
    int points = 0;
    for (const PlotPoint& point : series.points) {
        if (!drawable(point)) continue;
        fmt::format_to(std::back_inserter(path), "{:.1f},{:.1f} ", x_.at(point.x), y_of(point.y));
        ++points;
    }
    if (points < 2) return;
    put(R"(<polyline class="curve s{}{}" points="{}"/>)", index % inks.size(),
        series.dashed ? " dashed" : "", path);
}

void Drawing::markers(const PlotSeries& series, std::size_t index) {
    for (const PlotPoint& point : series.points) {
        if (!drawable(point)) continue;
        const double x = x_.at(point.x), y = y_of(point.y);
        put(R"(<g class="point"><title>{}</title>)", escaped(point.detail));
        marker(index, x, y, series.dashed ? "hollow" : "solid");
        if (point.ringed) {
            put(R"(<circle class="ring" cx="{:.1f}" cy="{:.1f}" r="13"/>)", x, y);
        }
        if (point.flagged) {
            put(R"(<path class="flag" d="M{0:.1f} {1:.1f}l22 22m0 -22l-22 22"/>)", x - 11, y - 11);
        }
        put("</g>");
        taken_.push_back({x - 8, y - 8, x + 8, y + 8});
    }
}

void Drawing::marker(std::size_t index, double x, double y, const char* kind) {
    constexpr std::array<const char*, 4> shapes{"M-7 0a7 7 0 1 0 14 0a7 7 0 1 0 -14 0z",
                                                "M-6 -6h12v12h-12z", "M0 -8l8 14h-16z",
                                                "M0 -9l8 9l-8 9l-8 -9z"};
    put(R"svg(<path class="{} s{}" transform="translate({:.1f} {:.1f})" d="{}"/>)svg", kind,
        index % inks.size(), x, y, shapes[index % shapes.size()]);
}

void Drawing::label(const PlotPoint& point, double x, double y) {
    if (point.label.empty()) return;
    const double wide = text_width(point.label, 14);
    const std::array<std::pair<double, double>, 4> places{std::pair{x - wide / 2, y - 13},
                                                          {x - wide / 2, y + 24},
                                                          {x + 13, y + 5},
                                                          {x - wide - 13, y + 5}};
    for (const auto& [at, base] : places) {
        const Room room{at, base - 12, at + wide, base + 3};
        const bool inside = room.x0 > left && room.x1 < right && room.y0 > top && room.y1 < axis_y;
        const auto meets = [&](const Room& other) { return room.meets(other); };
        if (!inside || std::any_of(taken_.begin(), taken_.end(), meets)) continue;
        put(R"(<text class="label" x="{:.1f}" y="{:.1f}">{}</text>)", at, base,
            escaped(point.label));
        taken_.push_back(room);
        return;
    }
}

void Drawing::legend() {
    double x = left, y = legend_y;
    for (std::size_t i = 0; i < plot_->series.size(); ++i) {
        const PlotSeries& series = plot_->series[i];
        const double wide = 34 + text_width(series.name, 15) + 26;
        if (x > left && x + wide > right) {
            x = left;
            y += legend_step;
        }
        marker(i, x + 9, y - 5, series.dashed ? "hollow" : "solid");
        put(R"(<text class="legend" x="{:.1f}" y="{:.1f}">{}</text>)", x + 26, y,
            escaped(series.name));
        x += wide;
    }
    height_ = y + 18;
}

std::string Drawing::style() const {
    std::string light, dark;
    for (std::size_t i = 0; i < inks.size(); ++i) {
        const auto rules = [&](const char* ink) {
            return fmt::format(
                ".lp .solid.s{0}{{fill:{1}}}.lp .hollow.s{0},.lp .curve.s{0}{{stroke:{1}}}", i,
                ink);
        };
        light += rules(inks[i].light);
        dark += rules(inks[i].dark);
    }
    return R"(<style>
.lp{font-family:system-ui,"Segoe UI","DejaVu Sans",sans-serif}
.lp .paper{fill:#fff}.lp .area{fill:none;stroke:#8a929c}.lp .floor{fill:#eef1f4}
.lp text{fill:#22272e;font-size:15px}.lp .title{font-size:19px;font-weight:600}
.lp .tick,.lp .hint{fill:#57606a;font-size:14px}.lp .hint{font-style:italic}
.lp .note,.lp .label{font-size:14px;paint-order:stroke;stroke:#fff;stroke-width:4px}.lp .middle{text-anchor:middle}.lp .end{text-anchor:end}
.lp .grid{stroke:#e3e7eb}.lp .grid.decade{stroke:#c8ced5}.lp .mark{stroke:#8a929c}
.lp .baseline{stroke:#57606a;stroke-width:2;stroke-dasharray:2 4;stroke-linecap:round}
.lp .curve{fill:none;stroke-width:2.5}.lp .dashed{stroke-dasharray:8 6}
.lp .hollow{fill:#fff;stroke-width:2.5}.lp .flag{stroke:#d1001f;stroke-width:3;fill:none}
.lp .ring{fill:none;stroke:#22272e;stroke-width:1.5}
)" + light +
           R"(
@media (prefers-color-scheme:dark){.lp .paper,.lp .hollow{fill:#1b1f24}.lp .floor{fill:#262c33}
.lp text{fill:#e6eaef}.lp .note,.lp .label{stroke:#1b1f24}.lp .tick,.lp .hint{fill:#a9b3be}.lp .grid{stroke:#2c333b}
.lp .grid.decade{stroke:#444d57}.lp .baseline{stroke:#a9b3be}.lp .flag{stroke:#ff6473}.lp .ring{stroke:#e6eaef}
)" + dark + "}\n</style>\n";
}

std::string Drawing::text() {
    frame();
    x_ticks();
    y_ticks();
    vertical_line();
    for (std::size_t i = 0; i < plot_->series.size(); ++i) lines(plot_->series[i], i);
    for (std::size_t i = 0; i < plot_->series.size(); ++i) markers(plot_->series[i], i);
    for (const PlotSeries& series : plot_->series) {
        for (const PlotPoint& point : series.points) {
            if (drawable(point)) label(point, x_.at(point.x), y_of(point.y));
        }
    }
    legend();
    return fmt::format(
        "<svg class=\"lp\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" "
        "role=\"img\" aria-label=\"{2}\">\n{3}<rect class=\"paper\" width=\"{0}\" "
        "height=\"{1}\"/>\n{4}</svg>\n",
        width, height_, escaped(plot_->title), style(), body_);
}

}  // namespace

std::span<const Ink> plot_inks() {
    return inks;
}

std::string svg_of(const LogPlot& plot) {
    return Drawing(plot).text();
}

}  // namespace luch
