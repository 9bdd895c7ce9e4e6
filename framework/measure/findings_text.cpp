#include "framework/base/text.h"
#include "framework/measure/findings.h"
#include "framework/measure/numbers.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace luch {
namespace {

using Sentences = std::vector<std::string>;

/// The least error that was measured against a truth; infinite when there is none.
double smallest_error(const SceneReport& scene, const LabTruth& truth) {
    double least = std::numeric_limits<double>::infinity();
    const auto take = [&](const Errors& errors) {
        if (errors.rmse > 0) least = std::min(least, errors.rmse);
    };
    for (const LabSeries& series : scene.series) {
        for (const LabPoint& point : series.points) {
            if (!point.ran()) continue;
            if (series.truth == truth.name) take(point.errors);
            if (scene.converged == truth.name && point.converged) take(*point.converged);
        }
    }
    return least;
}

void add_truth(const SceneReport& scene, const LabTruth& truth, Sentences& all) {
    const double smallest = smallest_error(scene, truth);
    if (truth.exact || !std::isfinite(smallest)) return;
    const double ratio = truth.standard_error / smallest;
    const std::string facts = fmt::format(
        "{}: its own standard error is {}, {} of the smallest error measured against it",
        truth.name, three_digits(truth.standard_error), percent(ratio, 1));
    if (truth.good_to(smallest)) {
        all.push_back("truth, " + facts);
        return;
    }
    const double times = std::pow(5 * ratio, 2);
    const auto wanted = static_cast<std::uint64_t>(std::round(truth.samples * times));
    all.push_back(
        fmt::format("WARNING: truth, {}, more than a fifth: errors that small are partly "
                    "the truth's own; {} would do",
                    facts,
                    truth.baseline ? fmt::format("{:.1f} times its work", times)
                                   : fmt::format("about {} samples a pixel", grouped(wanted))));
}

std::string slope_text(const SlopeFinding& slope) {
    return fmt::format("{:.2f} ± {}, {:.2f} expected", slope.fit.slope,
                       three_digits(slope.fit.half_width), slope.expected);
}

void add_slopes(const LabSeries& series, Sentences& all) {
    const auto add = [&](const std::optional<SlopeFinding>& slope, const std::string& over) {
        if (!slope) return;
        std::string text = fmt::format("{}: slope of the linear RMSE over {}: {}", series.technique,
                                       over, slope_text(*slope));
        if (slope->differs()) {
            const bool flat = slope->fit.slope > slope->expected;
            text = "WARNING: " + text +
                   (flat ? "; it converges more slowly than it should"
                         : "; it converges faster than was expected");
        }
        all.push_back(std::move(text));
    };
    add(slope_of(series), series.parameter);
    add(passes_slope(series), "the number of independent frames");
}

void add_floor_or_efficiency(const LabSeries& series, Sentences& all) {
    if (const auto best = efficiency_of(series)) {
        all.push_back(fmt::format("{}: efficiency 1/(variance · s) {} at {}", series.technique,
                                  three_digits(best->value), best->setting));
    }
    const std::optional<double> floor = floor_of(series);
    if (floor && *floor > 0) {
        all.push_back(fmt::format("{}: floor RMSE {}: what no setting gets rid of",
                                  series.technique, three_digits(*floor)));
    }
}

void add_break_even(const SceneReport& scene, const LabSeries& series, Sentences& all) {
    // Below what a clock tells apart there is nothing to pay back.
    constexpr double least_prepare_ms = 0.5;
    const LabPoint* best = series.best();
    if (best == nullptr || series.by_samples || best->prepare_ms < least_prepare_ms) return;
    const double exact_ms = scene.speedup(*best) * best->frame_ms;
    const auto frames = break_even_frames(best->prepare_ms, exact_ms, best->frame_ms);
    const std::string prepares = fmt::format("{}: {} ms of preparation are ", series.technique,
                                             milliseconds(best->prepare_ms));
    all.push_back(prepares +
                  (frames
                       ? "paid back after " + counted(static_cast<std::uint64_t>(*frames), "frame")
                       : "never paid back: its frames are no faster than the baseline's"));
}

void add_left_out(const LabSeries& series, Sentences& all) {
    if (!series.left_out) return;
    const LeftOutCost& cost = *series.left_out;
    all.push_back(fmt::format(
        "{}{}: with every stage run a frame takes {} ms, with what the scene does not need left "
        "out {} ms: {:+.1f} %",
        series.technique, cost.setting.empty() ? "" : " at " + cost.setting,
        milliseconds(cost.forced_ms), milliseconds(cost.planned_ms),
        100 * (cost.planned_ms / cost.forced_ms - 1)));
}

std::string by_how_much(const std::vector<Reached>& all, std::string_view better) {
    if (all.size() < 2) return "";
    if (all[0].value == 0) return fmt::format(", exactly; {} is next", all[1].technique);
    return fmt::format(", {} × {} than {}", three_digits(all[1].value / all[0].value), better,
                       all[1].technique);
}

void add_equal_time(const ErrorPlane& plane, double baseline_ms, const Metric& metric,
                    Sentences& all) {
    for (const EqualTime& row : at_equal_time(plane, baseline_ms)) {
        const Reached& best = row.errors.front();
        const bool tie = best.value == row.errors[1].value;
        all.push_back(fmt::format("within {} ms, against {}: {} is best, {} {}{}",
                                  milliseconds(row.ms), plane.truth, best.technique, metric.label,
                                  three_digits(best.value),
                                  tie ? ", and " + row.errors[1].technique + " as good"
                                      : by_how_much(row.errors, "better")));
    }
}

void add_equal_error(const ErrorPlane& plane, const Yardstick& yardstick, Sentences& all) {
    const EqualError reached = at_equal_error(plane, yardstick.good_enough);
    const std::string goal = fmt::format("{} ≤ {} against {}: ", yardstick.metric->label,
                                         three_digits(yardstick.good_enough), plane.truth);
    if (reached.ms.empty()) {
        all.push_back(goal + "nothing reaches it");
        return;
    }
    const Reached& best = reached.ms.front();
    std::string text = fmt::format("{}{} is fastest, {} ms{}", goal, best.technique,
                                   milliseconds(best.value), by_how_much(reached.ms, "faster"));
    if (!reached.not_reached.empty()) {
        text += "; not reached by " + listed(reached.not_reached, "and");
    }
    all.push_back(std::move(text));
}

}  // namespace

std::vector<std::string> findings(const SceneReport& scene, const Yardstick& yardstick) {
    Sentences all;
    for (const LabTruth& truth : scene.truths) add_truth(scene, truth, all);
    for (const LabSeries& series : scene.series) {
        add_slopes(series, all);
        add_floor_or_efficiency(series, all);
        add_break_even(scene, series, all);
        add_left_out(series, all);
    }
    for (const ErrorPlane& plane : planes_of(scene, *yardstick.metric)) {
        add_equal_time(plane, scene.baseline.frame_ms, *yardstick.metric, all);
        add_equal_error(plane, yardstick, all);
    }
    return all;
}

}  // namespace luch
