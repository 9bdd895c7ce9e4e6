#include "framework/apps/session.h"
#include "framework/apps/verbs.h"
#include "framework/base/error.h"
#include "framework/base/text.h"
#include "framework/measure/difference.h"
#include "framework/measure/flip.h"
#include "framework/measure/magma.h"
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

/// The metrics that a limit from above, or from below, may name.
std::string names(bool higher_is_better) {
    std::vector<std::string_view> all;
    for (const auto& some : {metrics(), special_metrics()}) {
        for (const Metric& metric : some) {
            if (metric.higher_is_better == higher_is_better) all.push_back(metric.name);
        }
    }
    return fmt::format("{}", fmt::join(all, ", "));
}

/// "320,240": a place in pixels; those of the top-left one are 0..1.
std::optional<Gaze> gaze_of(const std::string& text) {
    if (text.empty()) return std::nullopt;
    const std::vector<std::string> parts = split(text, ',');
    const auto x = parsed_number(parts.front()), y = parsed_number(parts.back());
    if (parts.size() != 2 || !x || !y) {
        throw Error("--gaze \"" + text + "\": write X,Y in pixels, as in 320,240");
    }
    return Gaze{{*x, *y}};
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
               "  luch compare baseline shadow_map scenes/fence/fence.scene -p mode=exact\n"
               "  luch compare truth.exr fast.exr --fail-above rmse=0.01 --fail-above flip=0.05\n"
               "  luch compare truth.png fast.png --flip-map out/flip.png --fail-below ssim=0.98\n"
               "  luch compare truth.png foveated.png --gaze 320,240\n"
               "The first is the reference. Two .exr or .hdr files compare in linear light (FLIP: "
               "HDR),\nall else as displayed (sRGB, clamped to 0..1; FLIP: LDR at 67 pixels per "
               "degree), unless\n--linear or --displayed is given. A pixel that is not finite "
               "makes it fail.\nA picture is told from a technique by the catalogue: write ./NAME "
               "for a file called as one.\n";
    }
    void declare(Arguments& arguments) override {
        arguments.positional("A", a_, "the reference: a picture or a technique");
        arguments.positional("B", b_, "what is compared with it: a picture or a technique");
        arguments.positional("SCENE", scene_, "a scene file, when A or B is a technique", false);
        arguments.option("-p,--param", params_, "KEY=VALUE", "a parameter of B, a technique");
        arguments.flag("--linear", linear_, "compare in linear light");
        arguments.flag("--displayed", displayed_, "compare as displayed, also .exr and .hdr files");
        arguments.option("--difference", difference_, "FILE", "write |A − B|, amplified");
        arguments.option("--amplify", amplify_, "X", "by how much [10]");
        arguments.option("--flip-map", flip_map_, "FILE",
                         "write FLIP's error of every pixel, black for 0 to light yellow for 1");
        arguments.option("--gaze", gaze_, "X,Y", "also weigh errors by acuity around this pixel");
        arguments.option("--fail-above", above_, "METRIC=VALUE",
                         "exit with 1 when a metric is larger: " + names(false));
        arguments.option("--fail-below", below_, "METRIC=VALUE",
                         "exit with 1 when a metric is smaller: " + names(true));
        arguments.option("--frames", frames_, "N", "time N frames of a technique [3]");
        arguments.option("--json", json_, "FILE", "write the result as JSON");
        options_.declare(arguments);
    }
    int run() override;

 private:
    [[nodiscard]] std::vector<Limit> limits() const;
    [[nodiscard]] std::optional<Encoding> wanted_encoding(bool rendered) const;
    /// Prints every limit that does not hold.
    [[nodiscard]] bool within(const std::vector<Limit>& all, const Errors& errors) const;
    void write_pictures(const ComparablePair& pair) const;
    [[nodiscard]] std::pair<Side, Side> sides() const;
    [[nodiscard]] Side rendered(const std::string& name, const std::vector<std::string>& params,
                                const Session& session, const Shot& shot) const;
    void report(const Side& a, const Side& b, const ComparablePair& pair,
                const Errors& errors) const;
    void report_costs(const Side& a, const Side& b) const;
    [[nodiscard]] Json json_of(const Side& a, const Side& b, const ComparablePair& pair,
                               const Errors& errors, bool passed) const;

    std::string a_, b_, scene_, difference_, flip_map_, gaze_, json_;
    std::vector<std::string> params_, above_, below_;
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

Side Compare::rendered(const std::string& name, const std::vector<std::string>& params,
                       const Session& session, const Shot& shot) const {
    const auto technique = make_technique(name, params);
    std::string shown = name;
    for (const std::string& each : params) shown += " " + each;
    Budget budget = session.budget();
    budget.planes = false;
    Outcome outcome = luch::run(*technique, session.studio(), shot, budget, {1, frames_});
    if (!outcome.plan.applies) {
        throw Error(name + " does not apply to this scene: " + outcome.plan.why);
    }
    return {shown, {outcome.frame.colour, Encoding::linear}, std::move(outcome)};
}

std::pair<Side, Side> Compare::sides() const {
    std::array<Side, 2> both;
    std::array<bool, 2> made{};
    const std::array names{a_, b_};
    const std::array<std::vector<std::string>, 2> params{{{}, params_}};
    if (!params_.empty() && !is_technique(b_)) {
        throw Error("-p: " + b_ + " is no technique and has no parameters");
    }
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
        if (made[i]) both[i] = rendered(names[i], params[i], session, shot);
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
            fmt::print("{}: {} is still to be written; what stood in is not yours\n", side->name,
                       task);
        }
    }
    fmt::print("{}\n", table.text());
}

void Compare::report(const Side& a, const Side& b, const ComparablePair& pair,
                     const Errors& errors) const {
    fmt::print("{} (the reference) and {}, {} × {}, {}\n\n", a.name, b.name, pair.image.width(),
               pair.image.height(), pair.why);
    if (a.outcome || b.outcome) report_costs(a, b);
    const auto print = [&](const Metric& metric) {
        fmt::print("{:<8}{:>12}   {}\n", metric.label, shown(metric, errors), metric.meaning);
    };
    for (const Metric& metric : metrics()) print(metric);
    for (const Metric& metric : special_metrics()) {
        if (!std::isnan(errors.*metric.value)) print(metric);
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

/// A frame is compared as people see it, unless light itself is asked about.
std::optional<Encoding> Compare::wanted_encoding(bool rendered) const {
    if (linear_ && displayed_) throw Error("--linear and --displayed: choose one of the two");
    if (linear_) return Encoding::linear;
    if (displayed_ || rendered) return Encoding::srgb;
    return std::nullopt;
}

bool Compare::within(const std::vector<Limit>& all, const Errors& errors) const {
    bool fine = true;
    for (const Limit& limit : all) {
        if (limit.holds(errors)) continue;
        const Metric& metric = *limit.metric;
        if (std::isnan(errors.*metric.value) && !metric.needs.empty()) {
            throw Error(
                fmt::format("{0}: there is none here; it needs {1}", metric.name, metric.needs));
        }
        fine = false;
        fmt::print("FAILED: {} is {}, {} {}\n", metric.name, shown(metric, errors),
                   limit.above ? "above" : "below", limit.value);
    }
    return fine;
}

void Compare::write_pictures(const ComparablePair& pair) const {
    const auto reference = pair.reference.view(), image = pair.image.view();
    if (!difference_.empty()) {
        write_displayed(difference_, amplified_difference(reference, image, amplify_).view());
        fmt::print("{}: the difference, {} × amplified\n", difference_, amplify_);
    }
    if (flip_map_.empty()) return;
    const bool hdr = pair.encoding == Encoding::linear;
    const FlipResult flip = hdr ? flip_hdr(reference, image).flip : flip_ldr(reference, image);
    write_displayed(flip_map_, in_magma(flip.map.view()).view());
    fmt::print("{}: {}-FLIP of every pixel, black for 0 to light yellow for 1\n", flip_map_,
               hdr ? "HDR" : "LDR");
}

int Compare::run() {
    if (frames_ < 1 || frames_ > 1000) throw Error("--frames: give 1 to 1000");
    if (!(amplify_ > 0 && std::isfinite(amplify_))) throw Error("--amplify: give more than 0");
    const std::vector<Limit> all_limits = limits();
    const std::optional<Gaze> gaze = gaze_of(gaze_);
    const auto [a, b] = sides();
    const ComparablePair pair =
        comparable(a.picture, b.picture, wanted_encoding(a.outcome || b.outcome));
    const Errors errors =
        errors_between(pair.reference.view(), pair.image.view(), {pair.encoding, gaze});
    report(a, b, pair, errors);
    const bool passed = within(all_limits, errors) && errors.non_finite.count == 0;
    write_pictures(pair);
    if (!json_.empty()) json_of(a, b, pair, errors, passed).write(json_);
    return passed ? 0 : 1;
}

}  // namespace

std::unique_ptr<Verb> make_compare() {
    return std::make_unique<Compare>();
}

}  // namespace luch
