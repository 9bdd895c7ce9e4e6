#include "framework/apps/session.h"
#include "framework/apps/verbs.h"
#include "framework/base/error.h"
#include "framework/base/text.h"
#include "framework/measure/difference.h"
#include "framework/measure/metrics.h"
#include "framework/measure/numbers.h"
#include "framework/measure/report_json.h"
#include "framework/measure/table.h"
#include "framework/technique/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

namespace luch {
namespace {

/// A or B: a picture, and what it cost when a technique made it.
struct Side {
    std::string name;
    Picture picture;
    std::optional<Outcome> outcome;
};

bool is_technique(const std::string& name) {
    const auto all = catalogue();
    return std::any_of(all.begin(), all.end(),
                       [&](const TechniqueInfo& info) { return info.name == name; });
}

/// Whether a word means a file rather than a misspelt technique.
bool looks_like_file(const std::string& name) {
    return std::filesystem::exists(name) || !std::filesystem::path(name).extension().empty();
}

/// "rmse=0.01": a comparison fails beyond it.
struct Limit {
    const Metric* metric;
    double value;
    bool above;  ///< else it fails below

    /// NaN is on no side and fails.
    [[nodiscard]] bool holds(const Errors& errors) const {
        const double measured = errors.*metric->value;
        return above ? measured <= value : measured >= value;
    }
};

Limit limit_of(const std::string& text, bool above) {
    const std::string option = above ? "--fail-above" : "--fail-below";
    const std::size_t equals = text.find('=');
    const auto value = equals == std::string::npos
                           ? std::nullopt
                           : parsed_number(std::string_view(text).substr(equals + 1));
    if (!value) throw Error(option + " \"" + text + "\": write METRIC=NUMBER, as in rmse=0.01");
    const Metric& metric = find_metric(text.substr(0, equals));
    if (above && metric.higher_is_better) {
        throw Error(fmt::format("--fail-above {0}: a higher {0} is better; use --fail-below {1}",
                                metric.name, text));
    }
    return {&metric, *value, above};
}

class Compare final : public Verb {
 public:
    std::string_view name() const override { return "compare"; }
    std::string_view summary() const override {
        return "how far two pictures or techniques are apart";
    }
    std::string_view examples() const override {
        return "  luch compare before.png after.png\n"
               "  luch compare baseline vista scenes/room/room.scene --difference out/off.png\n"
               "  luch compare vista homework/vista scenes/room/room.scene --json out/mine.json\n"
               "  luch compare truth.exr fast.exr --fail-above rmse=0.01 --fail-above max=0.2\n"
               "The first is the reference. Two .exr or .hdr files compare in linear light, all "
               "else "
               "as\ndisplayed (sRGB, clamped to 0..1), unless --linear or --displayed is given. A "
               "picture is\n"
               "told from a technique by the catalogue: write ./NAME for a file called as one.\n";
    }
    void declare(Arguments& arguments) override {
        arguments.positional("A", a_, "the reference: a picture or a technique");
        arguments.positional("B", b_, "what is compared with it: a picture or a technique");
        arguments.positional("SCENE", scene_, "a scene file, when A or B is a technique", false);
        arguments.flag("--linear", linear_, "compare in linear light");
        arguments.flag("--displayed", displayed_, "compare as displayed, also .exr and .hdr files");
        arguments.option("--difference", difference_, "FILE", "write |A − B|, amplified");
        arguments.option("--amplify", amplify_, "X", "by how much [10]");
        arguments.option("--fail-above", above_, "METRIC=VALUE",
                         "exit with 1 when a metric is larger: rmse, relmse, max, p999");
        arguments.option("--fail-below", below_, "METRIC=VALUE",
                         "exit with 1 when a metric is smaller: psnr");
        arguments.option("--frames", frames_, "N", "time N frames of a technique [3]");
        arguments.option("--json", json_, "FILE", "write the result as JSON");
        options_.declare(arguments);
    }
    int run() override;

 private:
    [[nodiscard]] std::vector<Limit> limits() const;
    [[nodiscard]] std::pair<Side, Side> sides() const;
    [[nodiscard]] Side rendered(const std::string& name, const Session& session,
                                const Shot& shot) const;
    void report(const Side& a, const Side& b, const ComparablePair& pair,
                const Errors& errors) const;
    void report_costs(const Side& a, const Side& b) const;
    [[nodiscard]] Json json_of(const Side& a, const Side& b, const ComparablePair& pair,
                               const Errors& errors, bool passed) const;

    std::string a_, b_, scene_, difference_, json_;
    std::vector<std::string> above_, below_;
    double amplify_ = 10;
    int frames_ = 3;
    bool linear_ = false, displayed_ = false;
    SceneOptions options_;
};

std::vector<Limit> Compare::limits() const {
    std::vector<Limit> all;
    for (const std::string& text : above_) all.push_back(limit_of(text, true));
    for (const std::string& text : below_) all.push_back(limit_of(text, false));
    return all;
}

Side Compare::rendered(const std::string& name, const Session& session, const Shot& shot) const {
    const auto technique = make_technique(name);
    Outcome outcome = luch::run(*technique, session.studio(), shot, session.budget(), {1, frames_});
    if (!outcome.plan.applies) {
        throw Error(name + " does not apply to this scene: " + outcome.plan.why);
    }
    return {name, {outcome.frame.colour, Encoding::linear}, std::move(outcome)};
}

std::pair<Side, Side> Compare::sides() const {
    std::array<Side, 2> both;
    std::array<bool, 2> made{};
    const std::array names{a_, b_};
    for (std::size_t i = 0; i < 2; ++i) {
        made[i] = is_technique(names[i]);
        if (made[i]) continue;
        if (!looks_like_file(names[i])) find_technique(names[i]);
        both[i] = {names[i], read_picture(names[i]), std::nullopt};
    }
    if (!made[0] && !made[1]) {
        if (!scene_.empty()) throw Error("two pictures need no scene: leave out " + scene_);
        return {std::move(both[0]), std::move(both[1])};
    }
    if (scene_.empty()) {
        throw Error(
            fmt::format("{} is a technique: name a scene to render, as in `luch compare {} "
                        "{} scenes/room/room.scene`",
                        made[0] ? a_ : b_, a_, b_));
    }
    const Session session(scene_, options_);
    Shot shot = session.shot();
    for (std::size_t i = 0; i < 2; ++i) {
        if (!made[i] && options_.size.empty()) shot.size = both[i].picture.pixels.size();
    }
    for (std::size_t i = 0; i < 2; ++i) {
        if (made[i]) both[i] = rendered(names[i], session, shot);
    }
    return {std::move(both[0]), std::move(both[1])};
}

void Compare::report_costs(const Side& a, const Side& b) const {
    std::vector<std::string> header{"technique", "prep ms", "frame ms", "× faster", "rays"};
    for (const std::string_view kind : ray_kind_names) header.emplace_back(kind);
    header.insert(header.end(), {"object tests", "fallbacks"});
    TextTable table(header);
    const double first = a.outcome ? median(a.outcome->frame_ms) : 0;
    for (const Side* side : {&a, &b}) {
        if (!side->outcome) continue;
        const Outcome& outcome = *side->outcome;
        const double frame_ms = median(outcome.frame_ms);
        std::vector<std::string> row{
            side->name, milliseconds(outcome.prepare_ms), milliseconds(frame_ms),
            first > 0 ? three_digits(first / frame_ms) : "—", grouped(outcome.counts.all_rays())};
        for (const std::uint64_t rays : outcome.counts.rays) row.push_back(grouped(rays));
        row.push_back(grouped(outcome.counts.object_tests));
        row.push_back(grouped(outcome.counts.fallbacks));
        table.add(std::move(row));
        for (const std::string& task : outcome.unwritten) {
            fmt::print("{}: {} is still to be written; the reference stood in\n", side->name, task);
        }
    }
    fmt::print("{}\n", table.text());
}

void Compare::report(const Side& a, const Side& b, const ComparablePair& pair,
                     const Errors& errors) const {
    fmt::print("{} (the reference) and {}, {} × {}, {}\n\n", a.name, b.name, pair.image.width(),
               pair.image.height(), pair.why);
    if (a.outcome || b.outcome) report_costs(a, b);
    for (const Metric& metric : metrics()) {
        fmt::print("{:<8}{:>12}   {}\n", metric.label, shown(metric, errors), metric.meaning);
    }
    const std::uint64_t pixels = pair.image.size().area();
    if (errors.differing > 0) {
        fmt::print("{} of {} pixels differ ({}), most of all ({}, {})\n", grouped(errors.differing),
                   grouped(pixels),
                   percent(static_cast<double>(errors.differing), static_cast<double>(pixels)),
                   errors.max_at.x, errors.max_at.y);
    } else {
        fmt::print("no pixel differs\n");
    }
    if (errors.non_finite.count > 0) {
        fmt::print("FAILED: {} pixels are not finite, the first at ({}, {})\n",
                   grouped(errors.non_finite.count), errors.non_finite.first_x,
                   errors.non_finite.first_y);
    }
}

Json Compare::json_of(const Side& a, const Side& b, const ComparablePair& pair,
                      const Errors& errors, bool passed) const {
    Json json = Json::object().set("version", LUCH_VERSION).set("a", a.name).set("b", b.name);
    if (!scene_.empty()) json.set("scene", scene_);
    json.set("size", Json::array().push(pair.image.width()).push(pair.image.height()))
        .set("encoding", pair.encoding == Encoding::linear ? "linear" : "srgb");
    json = errors_json(errors, std::move(json));
    json.set("identical", errors.differing == 0 && errors.non_finite.count == 0);
    Json costs = Json::array();
    for (const Side* side : {&a, &b}) {
        if (!side->outcome) continue;
        const Outcome& outcome = *side->outcome;
        costs.push(Json::object()
                       .set("technique", side->name)
                       .set("threads", outcome.threads)
                       .set("prepare_ms", outcome.prepare_ms)
                       .set("frame_ms", median(outcome.frame_ms))
                       .set("rays", rays_json(outcome.counts))
                       .set("object_tests", outcome.counts.object_tests)
                       .set("fallbacks", outcome.counts.fallbacks)
                       .set("left_out", left_out_json(outcome.plan)));
    }
    json.set("techniques", std::move(costs));
    if (a.outcome && b.outcome) {
        json.set("speedup", median(a.outcome->frame_ms) / median(b.outcome->frame_ms));
    }
    return json.set("passed", passed);
}

int Compare::run() {
    if (frames_ < 1 || frames_ > 1000) throw Error("--frames: give 1 to 1000");
    if (!(amplify_ > 0 && std::isfinite(amplify_))) throw Error("--amplify: give more than 0");
    const std::vector<Limit> all_limits = limits();
    const auto [a, b] = sides();
    // A frame is compared as people see it, unless light itself is asked about.
    std::optional<Encoding> wanted;
    if (a.outcome || b.outcome) wanted = Encoding::srgb;
    if (linear_ && displayed_) throw Error("--linear and --displayed: choose one of the two");
    if (linear_) wanted = Encoding::linear;
    if (displayed_) wanted = Encoding::srgb;
    const ComparablePair pair = comparable(a.picture, b.picture, wanted);
    const Errors errors = errors_between(pair.reference.view(), pair.image.view());
    report(a, b, pair, errors);
    bool passed = errors.non_finite.count == 0;
    for (const Limit& limit : all_limits) {
        if (limit.holds(errors)) continue;
        passed = false;
        fmt::print("FAILED: {} is {}, {} {}\n", limit.metric->name, shown(*limit.metric, errors),
                   limit.above ? "above" : "below", limit.value);
    }
    if (!difference_.empty()) {
        write_displayed(
            difference_,
            amplified_difference(pair.reference.view(), pair.image.view(), amplify_).view());
        fmt::print("{}: the difference, {} × amplified\n", difference_, amplify_);
    }
    if (!json_.empty()) json_of(a, b, pair, errors, passed).write(json_);
    return passed ? 0 : 1;
}

}  // namespace

std::unique_ptr<Verb> make_compare() {
    return std::make_unique<Compare>();
}

}  // namespace luch
