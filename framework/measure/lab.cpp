#include "framework/measure/lab.h"

#include "framework/base/error.h"
#include "framework/measure/digest.h"
#include "framework/measure/lab_point.h"
#include "framework/measure/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace luch {
namespace {

std::string samples(int spp) {
    return counted(static_cast<std::uint64_t>(spp), "sample") + " a pixel";
}

std::string described(const Subject& subject) {
    std::string text(subject.info->name);
    if (!subject.assignment.empty()) text += " " + subject.assignment;
    if (subject.info->sweep.by_samples()) text += ", " + samples(subject.spp);
    return subject.skip ? text : text + ", nothing left out";
}

/// The least error that is no coincidence of two equal pictures; infinite when there is none.
double smallest_error(const std::vector<LabPoint>& points) {
    double least = std::numeric_limits<double>::infinity();
    for (const LabPoint& point : points) {
        if (point.ran() && point.errors.rmse > 0) least = std::min(least, point.errors.rmse);
    }
    return least;
}

/// The work of one scene. Costs are counted in frames of the baseline at one sample a pixel.
class SceneLab {
 public:
    SceneLab(const LabScene& scene, const TechniqueInfo& baseline, const LabOptions& options)
        : scene_(&scene),
          options_(&options),
          bench_{scene.studio, scene.shot, scene.budget},
          references_(options.cache, scene.content),
          pictures_(options.pictures, scene.name),
          baseline_{&baseline, "", 1, scene.budget.skip} {}

    SceneReport run(std::span<const TechniqueInfo* const> techniques);

 private:
    [[nodiscard]] double cost_of(const TechniqueInfo& info) const;
    [[nodiscard]] std::vector<int> spps_of(const TechniqueInfo& info) const;
    void begin(const std::string& what, double cost);
    Measurement measured_once(const Subject& subject, const Subject* beside);
    TruthPicture truth_for(const Subject& subject, int factor);
    void describe_scene();
    void measure_baseline();
    LabSeries series_by_samples(const TechniqueInfo& info);
    TruthPicture judge(LabSeries& series, const std::vector<Measurement>& measurements,
                       const Subject& subject);
    LabSeries series_by_parameter(const TechniqueInfo& info);
    /// What a technique that goes by no samples is to show.
    [[nodiscard]] const TruthPicture& approximated_by(const TechniqueInfo& info);
    [[nodiscard]] const TruthPicture& own_truth(const TechniqueInfo& info);
    LabPoint point_by_parameter(const Subject& subject);
    std::optional<LeftOutCost> left_out_cost(const LabPoint& point, const std::string& setting,
                                             const Subject& subject);
    void add_passes(LabSeries& series, const Subject& subject, const TruthPicture& truth);
    [[nodiscard]] std::string journal_key(std::string_view what) const;
    [[nodiscard]] int frames() const { return options_->repeat.warm_up + options_->repeat.frames; }

    const LabScene* scene_;
    const LabOptions* options_;
    Workbench bench_;
    ReferenceCache references_;
    Pictures pictures_;
    Subject baseline_;
    SceneReport report_;
    TruthPicture frame_truth_;               ///< the baseline's frame, which others approximate
    std::optional<TruthPicture> converged_;  ///< the baseline's
    std::map<const TechniqueInfo*, TruthPicture> own_truths_;
    double cost_ = 0, done_ = 0, next_ = 0, part_ = 0;
};

std::vector<int> SceneLab::spps_of(const TechniqueInfo& info) const {
    std::vector<int> spps;
    for (const double value : info.sweep.values) {
        if (value <= options_->most_spp) spps.push_back(static_cast<int>(value));
    }
    if (spps.empty()) spps.push_back(1);
    return spps;
}

double SceneLab::cost_of(const TechniqueInfo& info) const {
    if (!info.sweep.by_samples()) {
        const auto settings = std::max<std::size_t>(info.sweep.values.size(), 1);
        return 2.0 * static_cast<double>(settings + 1) * frames();
    }
    double cost = options_->truth_factor * spps_of(info).back() + 2 * options_->passes;
    for (const int spp : spps_of(info)) cost += (spp + 1) * frames();
    return cost + 2 * frames();
}

void SceneLab::begin(const std::string& what, double cost) {
    done_ += next_;
    next_ = cost;
    part_ = std::max(part_, done_ / cost_);
    if (options_->on_step) options_->on_step({what, part_});
}

std::string SceneLab::journal_key(std::string_view what) const {
    const Repeat& repeat = options_->repeat;
    Digest digest;
    digest.part("luch journal 1")
        .part(options_->measured_by)
        .part(scene_->content)
        .part(fmt::format("{}x{} seed {} skip {} threads {} repeat {}+{}", scene_->shot.size.width,
                          scene_->shot.size.height, scene_->shot.seed, scene_->budget.skip,
                          scene_->studio.workers.count(), repeat.warm_up, repeat.frames))
        .part(what);
    return digest.text();
}

Measurement SceneLab::measured_once(const Subject& subject, const Subject* beside) {
    begin(described(subject), (subject.spp + (beside != nullptr ? 1 : 0)) * frames());
    const bool kept = options_->journal && !scene_->content.empty();
    const std::string key =
        kept ? journal_key(fmt::format("measurement {} {} spp {} skip {} beside {}",
                                       subject.info->name, subject.assignment, subject.spp,
                                       subject.skip, beside == nullptr ? "" : described(*beside)))
             : "";
    if (const auto bytes = kept ? options_->journal->get(key) : std::nullopt) {
        if (std::optional<Measurement> before = measurement_of(*bytes)) {
            ++report_.resumed;
            return std::move(*before);
        }
    }
    Measurement measurement = measured(subject, beside, bench_, options_->repeat);
    if (kept && measurement.ran()) options_->journal->put(key, bytes_of(measurement));
    return measurement;
}

void SceneLab::describe_scene() {
    const Scene& scene = scene_->studio.scene;
    report_.scene = scene_->name;
    report_.size = scene_->shot.size;
    report_.nodes = scene.nodes.size();
    report_.lights = scene.lights.size();
    for (const Node& node : scene.nodes) {
        const auto* mesh = std::get_if<Mesh>(&scene.geometries[node.geometry]);
        if (mesh != nullptr) report_.triangles += mesh->triangles.size();
    }
}

void SceneLab::measure_baseline() {
    const Measurement at_one = measured_once(baseline_, nullptr);
    if (!at_one.ran()) {
        throw Error(fmt::format("{}: the baseline {}", scene_->name, at_one.not_run));
    }
    LabTruth facts;
    facts.name = fmt::format("{}, {}", baseline_.info->name, samples(1));
    facts.exact = true;
    frame_truth_ = truth_picture(facts, at_one.outcome.frame.colour);
    report_.truths.push_back(facts);
    report_.baseline = point_of(at_one, frame_truth_, nullptr);
    pictures_.add_to(report_.baseline, std::string(baseline_.info->name),
                     at_one.outcome.frame.colour, frame_truth_);
}

/// Of two seeds, so that it knows its own error.
const TruthPicture& SceneLab::own_truth(const TechniqueInfo& info) {
    const auto known = own_truths_.find(&info);
    if (known != own_truths_.end()) return known->second;
    const Subject subject{&info, std::string(info.truth), 1, scene_->budget.skip};
    begin("truth: " + described(subject), 2);
    const std::uint64_t seed = scene_->shot.seed;
    const Reference reference = reference_of_halves(picture_of(subject, bench_, seed + 1),
                                                    picture_of(subject, bench_, seed + 2));
    LabTruth facts;
    facts.name = described(subject);
    facts.samples = 2;
    facts.standard_error = reference.displayed_error;
    TruthPicture truth = truth_picture(facts, reference.linear);
    truth.facts.baseline = errors_between(truth.shown.view(), frame_truth_.shown.view());
    report_.truths.push_back(truth.facts);
    pictures_.add_to(report_.truths.back(), fmt::format("{} truth", info.name), truth);
    return own_truths_.emplace(&info, std::move(truth)).first->second;
}

const TruthPicture& SceneLab::approximated_by(const TechniqueInfo& info) {
    if (!info.truth.empty()) return own_truth(info);
    const bool many_samples = info.whole_lens && scene_->shot.camera.has_lens() && converged_;
    return many_samples ? *converged_ : frame_truth_;
}

LabPoint SceneLab::point_by_parameter(const Subject& subject) {
    const Measurement measurement = measured_once(subject, &baseline_);
    const TruthPicture& truth = approximated_by(*subject.info);
    LabPoint point = point_of(measurement, truth, converged_ ? &*converged_ : nullptr);
    if (subject.info->resolution > 0 && point.ran()) {
        point.linear_rmse = rmse_within_white(truth, measurement.outcome.frame.colour);
    }
    pictures_.add_to(point, fmt::format("{} {}", subject.info->name, subject.assignment),
                     measurement.outcome.frame.colour, truth);
    return point;
}

LabSeries SceneLab::series_by_parameter(const TechniqueInfo& info) {
    LabSeries series{std::string(info.name),
                     std::string(info.title),
                     "",
                     approximated_by(info).facts.name,
                     {},
                     false,
                     info.sweep.slope};
    Subject subject{&info, "", 1, scene_->budget.skip};
    if (info.sweep.values.empty()) series.points.push_back(point_by_parameter(subject));
    for (const double value : info.sweep.values) {
        series.parameter = info.sweep.parameter;
        subject.assignment = series.parameter + "=" + exact_number(value);
        series.points.push_back(point_by_parameter(subject));
        series.points.back().value = value;
    }
    const LabPoint& last = series.points.back();
    series.left_out = left_out_cost(last, series.setting(last), subject);
    return series;
}

std::optional<LeftOutCost> SceneLab::left_out_cost(const LabPoint& point,
                                                   const std::string& setting,
                                                   const Subject& subject) {
    const auto& stages = point.plan.stages;
    const bool any =
        std::any_of(stages.begin(), stages.end(), [](const Stage& stage) { return !stage.needed; });
    if (!point.ran() || !any || !subject.skip) return std::nullopt;
    Subject forced = subject;
    forced.skip = false;
    const Measurement measurement = measured_once(forced, &subject);
    if (!measurement.ran()) return std::nullopt;
    return LeftOutCost{setting, measurement.beside(), median(measurement.outcome.frame_ms)};
}

TruthPicture SceneLab::truth_for(const Subject& subject, int factor) {
    const int wanted = std::max(2, factor * spps_of(*subject.info).back());
    begin(fmt::format("truth: {}, {}", subject.info->name, samples(wanted)), wanted);
    const Reference reference = references_.reference(subject, bench_, wanted);
    LabTruth facts;
    facts.name =
        fmt::format("{}, {} in two halves", subject.info->name, samples(reference.samples));
    facts.samples = reference.samples;
    facts.standard_error = reference.displayed_error;
    facts.from_cache = reference.from_cache;
    return truth_picture(facts, reference.linear);
}

/// The truth of a series by samples, and the errors against it. When it turns out to be too noisy
/// for them, once more with a better one.
TruthPicture SceneLab::judge(LabSeries& series, const std::vector<Measurement>& measurements,
                             const Subject& subject) {
    const bool is_baseline = subject.info == baseline_.info;
    const auto judged_by = [&](const TruthPicture& truth) {
        for (std::size_t i = 0; i < measurements.size(); ++i) {
            const double value = series.points[i].value;
            const TruthPicture* converged = converged_ ? &*converged_ : nullptr;
            series.points[i] = point_of(measurements[i], truth, is_baseline ? &truth : converged);
            series.points[i].value = value;
        }
    };
    TruthPicture truth = truth_for(subject, options_->truth_factor);
    judged_by(truth);
    if (truth.facts.good_to(smallest_error(series.points))) return truth;
    cost_ += options_->better_truth_factor * series.points.back().value;
    truth = truth_for(subject, options_->better_truth_factor);
    judged_by(truth);
    return truth;
}

LabSeries SceneLab::series_by_samples(const TechniqueInfo& info) {
    LabSeries series{std::string(info.name),
                     std::string(info.title),
                     std::string(samples_parameter),
                     "",
                     {},
                     true,
                     info.sweep.slope};
    Subject subject{&info, "", 1, scene_->budget.skip};
    std::vector<Measurement> measurements;
    for (const int spp : spps_of(info)) {
        subject.spp = spp;
        measurements.push_back(measured_once(subject, &baseline_));
        LabPoint& point = series.points.emplace_back();
        point.value = spp;
        point.not_run = measurements.back().not_run;
        if (!point.ran()) return series;
    }
    const TruthPicture truth = judge(series, measurements, subject);
    series.truth = truth.facts.name;
    report_.truths.push_back(truth.facts);
    pictures_.add_to(report_.truths.back(), fmt::format("{} truth", info.name), truth);
    for (std::size_t i = 0; i < series.points.size(); ++i) {
        pictures_.add_to(series.points[i],
                         fmt::format("{} {}", info.name, series.setting(series.points[i])),
                         measurements[i].outcome.frame.colour, truth);
    }
    add_passes(series, subject, truth);
    subject.spp = spps_of(info).front();
    series.left_out =
        left_out_cost(series.points.front(), series.setting(series.points.front()), subject);
    if (&info == baseline_.info) {
        converged_ = truth;
        report_.converged = truth.facts.name;
    }
    return series;
}

void SceneLab::add_passes(LabSeries& series, const Subject& subject, const TruthPicture& truth) {
    if (options_->passes < 2) return;
    begin(fmt::format("{}: independent frames", subject.info->name), 2 * options_->passes);
    const bool kept = options_->journal && !scene_->content.empty();
    const std::string key = kept ? journal_key(fmt::format("passes {} {} of {}", subject.info->name,
                                                           options_->passes, truth.facts.name))
                                 : "";
    if (const auto bytes = kept ? options_->journal->get(key) : std::nullopt) {
        if (std::optional<LabPasses> before = passes_of(*bytes)) {
            series.passes = std::move(*before);
            return;
        }
    }
    series.passes = independent_passes(subject, bench_, truth.linear, options_->passes);
    if (kept) options_->journal->put(key, bytes_of(series.passes));
}

SceneReport SceneLab::run(std::span<const TechniqueInfo* const> techniques) {
    cost_ = frames() + cost_of(*baseline_.info);
    for (const TechniqueInfo* info : techniques) cost_ += cost_of(*info);
    describe_scene();
    measure_baseline();
    LabSeries baseline = series_by_samples(*baseline_.info);
    for (const TechniqueInfo* info : techniques) {
        report_.series.push_back(info->sweep.by_samples() ? series_by_samples(*info)
                                                          : series_by_parameter(*info));
    }
    report_.series.push_back(std::move(baseline));
    return std::move(report_);
}

}  // namespace

LabOptions LabOptions::quick() {
    LabOptions options;
    options.most_spp = 8;
    options.passes = 16;
    options.repeat.frames = 3;
    return options;
}

SceneReport run_lab(const LabScene& scene, const TechniqueInfo& baseline,
                    std::span<const TechniqueInfo* const> techniques, const LabOptions& options) {
    return SceneLab(scene, baseline, options).run(techniques);
}

}  // namespace luch
