#include "framework/measure/lab.h"

#include "framework/base/error.h"
#include "framework/measure/difference.h"
#include "framework/measure/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

namespace luch {
namespace {

std::string samples(int spp) {
    return counted(static_cast<std::uint64_t>(spp), "sample") + " a pixel";
}

/// A file name without folders or blanks: "homework/vista lod=4" → "homework-vista-lod=4".
std::string file_name(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '/' || c == ' ' || c == '\\'; }, '-');
    return text;
}

/// What errors are measured against: a frame, and how it is called.
struct Truth {
    std::string name;
    Image<Rgb> linear, shown;
};

Truth truth_of(std::string name, const Outcome& outcome) {
    return {std::move(name), outcome.frame.colour, displayed(outcome.frame.colour.view())};
}

/// The work of one scene. Costs are counted in frames of the baseline at one sample a pixel.
class SceneLab {
 public:
    SceneLab(const LabScene& scene, const TechniqueInfo& baseline, const LabOptions& options)
        : scene_(&scene), baseline_(&baseline), options_(&options) {}

    SceneReport run(std::span<const TechniqueInfo* const> techniques);

 private:
    [[nodiscard]] double cost_of_all(std::span<const TechniqueInfo* const> techniques) const;
    void begin(const std::string& what, double cost);
    Outcome run_baseline(int spp, std::uint64_t seed, Repeat repeat) const;
    LabSeries technique_series(const TechniqueInfo& info, const Truth& truth);
    LabSeries baseline_series(const Outcome& at_one);
    LabPoint technique_point(const TechniqueInfo& info, const std::string& assignment,
                             const Truth& truth) const;
    void finish_point(LabPoint& point, const std::string& name, const Outcome& outcome,
                      const Truth& truth) const;
    [[nodiscard]] std::filesystem::path written(const std::string& name,
                                                ImageView<const Rgb> shown) const;
    [[nodiscard]] int frames() const { return options_->repeat.warm_up + options_->repeat.frames; }

    const LabScene* scene_;
    const TechniqueInfo* baseline_;
    const LabOptions* options_;
    double cost_ = 0, done_ = 0, next_ = 0;
};

double SceneLab::cost_of_all(std::span<const TechniqueInfo* const> techniques) const {
    double cost = frames() + options_->truth_spp;
    for (const int spp : options_->spp) cost += spp == 1 ? 0 : spp * frames();
    for (const TechniqueInfo* info : techniques) {
        cost += static_cast<double>(std::max<std::size_t>(info->sweep.values.size(), 1)) * frames();
    }
    return cost;
}

void SceneLab::begin(const std::string& what, double cost) {
    done_ += next_;
    next_ = cost;
    if (options_->on_step) options_->on_step({what, done_ / cost_});
}

Outcome SceneLab::run_baseline(int spp, std::uint64_t seed, Repeat repeat) const {
    const std::unique_ptr<Technique> technique = baseline_->create();
    Shot shot = scene_->shot;
    shot.spp = spp;
    shot.seed = seed;
    Outcome outcome = luch::run(*technique, scene_->studio, shot, scene_->budget, repeat);
    if (!outcome.plan.applies) {
        throw Error(
            fmt::format("{}: the baseline does not apply: {}", scene_->name, outcome.plan.why));
    }
    return outcome;
}

std::filesystem::path SceneLab::written(const std::string& name, ImageView<const Rgb> shown) const {
    if (options_->pictures.empty()) return {};
    auto file = options_->pictures / (file_name(scene_->name + " " + name) + ".png");
    write_displayed(file, shown);
    return file;
}

void SceneLab::finish_point(LabPoint& point, const std::string& name, const Outcome& outcome,
                            const Truth& truth) const {
    point.prepare_ms = outcome.prepare_ms;
    point.frame_ms = median(outcome.frame_ms);
    point.frames = static_cast<int>(outcome.frame_ms.size());
    point.counts = outcome.counts;
    point.bytes = outcome.bytes;
    point.unwritten = outcome.unwritten;
    const Image<Rgb> shown = displayed(outcome.frame.colour.view());
    point.errors = errors_between(truth.shown.view(), shown.view());
    point.identical = outcome.frame.colour == truth.linear;
    point.picture = written(name, shown.view());
    if (!point.identical) {
        point.difference =
            written(name + " difference", error_map(truth.shown.view(), shown.view()).view());
    }
}

LabPoint SceneLab::technique_point(const TechniqueInfo& info, const std::string& assignment,
                                   const Truth& truth) const {
    LabPoint point;
    try {
        const std::unique_ptr<Technique> technique = info.create();
        if (!assignment.empty()) set_param(*technique, assignment);
        Shot shot = scene_->shot;
        shot.spp = 1;
        const Outcome outcome =
            luch::run(*technique, scene_->studio, shot, scene_->budget, options_->repeat);
        point.plan = outcome.plan;
        if (!outcome.plan.applies) {
            point.not_run = "does not apply: " + outcome.plan.why;
        } else {
            finish_point(point, std::string(info.name) + " " + assignment, outcome, truth);
        }
    } catch (const std::exception& error) {
        // One technique's failure (a homework's, say) must not cost the hours of the others.
        point.not_run = fmt::format("failed: {}", error.what());
    }
    return point;
}

LabSeries SceneLab::technique_series(const TechniqueInfo& info, const Truth& truth) {
    LabSeries series{std::string(info.name), std::string(info.title), "", truth.name, {}, false};
    if (info.sweep.values.empty()) {
        begin(series.technique, frames());
        series.points.push_back(technique_point(info, "", truth));
        return series;
    }
    series.parameter = info.sweep.parameter;
    for (const double value : info.sweep.values) {
        const std::string assignment = series.parameter + "=" + exact_number(value);
        begin(series.technique + " " + assignment, frames());
        series.points.push_back(technique_point(info, assignment, truth));
        series.points.back().value = value;
    }
    return series;
}

LabSeries SceneLab::baseline_series(const Outcome& at_one) {
    const std::uint64_t seed = scene_->shot.seed;
    const std::string name(baseline_->name);
    const std::string truth_name =
        fmt::format("{}, {}, seed {}", name, samples(options_->truth_spp), seed + 1);
    begin(truth_name, options_->truth_spp);
    const Truth truth = truth_of(truth_name, run_baseline(options_->truth_spp, seed + 1, {0, 1}));
    LabSeries series{name, std::string(baseline_->title), "spp", truth.name, {}, true};
    for (const int spp : options_->spp) {
        if (spp != 1) begin(fmt::format("{}, {}", name, samples(spp)), spp * frames());
        const Outcome outcome = spp == 1 ? Outcome{} : run_baseline(spp, seed, options_->repeat);
        const Outcome& measured = spp == 1 ? at_one : outcome;
        LabPoint point;
        point.value = spp;
        point.plan = measured.plan;
        finish_point(point, fmt::format("{} spp={}", name, spp), measured, truth);
        series.points.push_back(std::move(point));
    }
    return series;
}

SceneReport SceneLab::run(std::span<const TechniqueInfo* const> techniques) {
    cost_ = cost_of_all(techniques);
    const Scene& scene = scene_->studio.scene;
    SceneReport report;
    report.scene = scene_->name;
    report.size = scene_->shot.size;
    report.nodes = scene.nodes.size();
    report.lights = scene.lights.size();
    for (const Node& node : scene.nodes) {
        const auto* mesh = std::get_if<Mesh>(&scene.geometries[node.geometry]);
        if (mesh != nullptr) report.triangles += mesh->triangles.size();
    }
    const std::string name = fmt::format("{}, {}", baseline_->name, samples(1));
    begin(name, frames());
    const Outcome at_one = run_baseline(1, scene_->shot.seed, options_->repeat);
    const Truth truth = truth_of(name, at_one);
    report.baseline.plan = at_one.plan;
    finish_point(report.baseline, std::string(baseline_->name), at_one, truth);
    for (const TechniqueInfo* info : techniques) {
        report.series.push_back(technique_series(*info, truth));
    }
    report.series.push_back(baseline_series(at_one));
    return report;
}

}  // namespace

LabOptions LabOptions::quick() {
    LabOptions options;
    options.spp = {1, 4};
    options.truth_spp = 16;
    options.repeat.frames = 3;
    return options;
}

SceneReport run_lab(const LabScene& scene, const TechniqueInfo& baseline,
                    std::span<const TechniqueInfo* const> techniques, const LabOptions& options) {
    return SceneLab(scene, baseline, options).run(techniques);
}

}  // namespace luch
