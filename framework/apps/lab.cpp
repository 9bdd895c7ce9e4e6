#include "framework/measure/lab.h"

#include "framework/apps/progress.h"
#include "framework/apps/session.h"
#include "framework/apps/verbs.h"
#include "framework/base/error.h"
#include "framework/base/text.h"
#include "framework/measure/digest.h"
#include "framework/measure/findings.h"
#include "framework/measure/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace luch {
namespace {

/// More than all frames of a long lab take, which only one report needs.
constexpr std::uintmax_t journal_bytes = std::uintmax_t{8} << 30;

/// A word as a shell takes it.
std::string shell_word(const std::string& word) {
    const auto plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
               std::string_view("-_./=,:+").find(c) != std::string_view::npos;
    };
    if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

class Lab final : public Verb {
 public:
    std::string_view name() const override { return "lab"; }
    std::string_view summary() const override {
        return "error against run time: table, curves, report";
    }
    std::string_view examples() const override {
        return "  luch lab scenes/room/room.scene                 every technique, "
               "out/lab/report.html\n"
               "  luch lab scenes/*/*.scene --quick               fewer frames and samples\n"
               "  luch lab room.scene -t vista,homework/vista     your own beside the reference\n"
               "  luch lab room.scene --size 640x480 --out out/room-lab\n";
    }
    void declare(Arguments& arguments) override {
        arguments.positional("SCENE", scenes_, "scene files");
        arguments.option(
            "-t,--technique", techniques_, "NAMES",
            "which, with commas between them [all that approximate the baseline, but homework]");
        arguments.flag("--quick", quick_, "fewer frames and samples: for a first look");
        arguments.option("--out", out_, "DIR", "where the report is written [out/lab]");
        arguments.option("--at", at_, "METRIC=ERROR",
                         "what equal error means [flip=0.05; without FLIP rmse=0.05]");
        arguments.option("--cache", cache_, "DIR",
                         "where references are kept [$XDG_CACHE_HOME/luch or ~/.cache/luch]");
        arguments.flag(
            "--fresh", fresh_,
            "measure everything anew, also what an interrupted run has measured already");
        options_.declare(arguments);
    }
    int run() override {
        if (options_.spp != 0) {
            throw Error("--spp: the lab walks along samples a pixel by itself; leave it out");
        }
        if (!options_.camera.empty() && scenes_.size() > 1) {
            throw Error("--camera: give it with one scene only");
        }
        const std::vector<const TechniqueInfo*> techniques = chosen();
        LabReport report;
        report.command = command();
        if (!at_.empty()) report.yardstick = parsed_yardstick(at_);
        const Store journal(std::filesystem::path(out_) / "journal", journal_bytes);
        if (fresh_) journal.clear();
        Progress progress;
        for (std::size_t i = 0; i < scenes_.size(); ++i) {
            add_scene(report, i, techniques, journal, progress);
        }
        write_report(report, out_);
        // The report is whole; the next one is to measure the program of its own day.
        journal.clear();
        fmt::print("{}\n", (std::filesystem::path(out_) / "report.html").string());
        return all_finite_in(report) ? 0 : 1;
    }

 private:
    [[nodiscard]] std::vector<const TechniqueInfo*> chosen() const {
        std::vector<const TechniqueInfo*> techniques;
        for (const std::string& list : techniques_) {
            for (const std::string& name : split(list, ',')) {
                const TechniqueInfo& info = find_technique(trimmed(name));
                const bool known =
                    std::find(techniques.begin(), techniques.end(), &info) != techniques.end();
                if (info.name != "baseline" && !known) techniques.push_back(&info);
            }
        }
        if (!techniques_.empty()) return techniques;
        for (const TechniqueInfo& info : catalogue()) {
            if (info.name == "baseline" || info.name.starts_with("homework/")) continue;
            if (!info.approximates && info.truth.empty()) continue;
            techniques.push_back(&info);
        }
        return techniques;
    }

    /// With the path tracer for a scene that asks for global illumination, unless the user has
    /// chosen.
    [[nodiscard]] std::vector<const TechniqueInfo*> chosen_for(
        const Scene& scene, std::vector<const TechniqueInfo*> techniques) const {
        const std::string usual = default_technique(scene);
        if (techniques_.empty() && usual != "baseline") {
            techniques.push_back(&find_technique(usual));
        }
        return techniques;
    }

    [[nodiscard]] std::optional<Store> references() const {
        const std::filesystem::path folder =
            cache_.empty() ? default_cache_folder() : std::filesystem::path(cache_);
        if (folder.empty()) return std::nullopt;
        std::error_code problem;
        if (!cache_.empty()) std::filesystem::create_directories(folder, problem);
        if (problem) {
            throw Error(fmt::format("--cache {}: cannot be made ({}); choose a folder of your own",
                                    cache_, problem.message()));
        }
        return Store(folder);
    }

    void add_scene(LabReport& report, std::size_t index,
                   const std::vector<const TechniqueInfo*>& techniques, const Store& journal,
                   Progress& progress) const {
        const auto count = static_cast<double>(scenes_.size());
        const Session session(scenes_[index], options_);
        report.machine = this_machine(session.studio().workers.count());
        const LabScene scene{unused_name(report, scenes_[index]), session.studio(), session.shot(),
                             session.budget(), content_of(session)};
        LabOptions options = quick_ ? LabOptions::quick() : LabOptions{};
        options.pictures = std::filesystem::path(out_) / "pictures";
        options.cache = references();
        options.journal = journal;
        options.measured_by = digest_of_files(std::array{std::filesystem::path("/proc/self/exe")}) +
                              report.machine.cpu;
        options.on_step = [&](const LabStep& step) {
            progress.step((static_cast<double>(index) + step.begun) / count,
                          scene.name + ": " + step.what);
        };
        report.scenes.push_back(run_lab(scene, find_technique("baseline"),
                                        chosen_for(session.scene(), techniques), options));
        progress.clear();
        const SceneReport& done = report.scenes.back();
        fmt::print("{}, {} × {} pixels\n{}", done.scene, done.size.width, done.size.height,
                   report_text(done));
        for (const std::string& sentence : verdicts(done)) fmt::print("{}\n", sentence);
        fmt::print("\n");
        for (const std::string& sentence : findings(done, report.yardstick)) {
            fmt::print("{}\n", sentence);
        }
        if (done.resumed > 0) {
            fmt::print("{} taken over from an interrupted run; --fresh measures all anew\n",
                       counted(static_cast<std::uint64_t>(done.resumed), "measurement"));
        }
        fmt::print("\n");
    }

    /// All that scene and camera come from, and what finds the triangles.
    [[nodiscard]] std::string content_of(const Session& session) const {
        return Digest()
            .part(digest_of_files(session.files()))
            .part(options_.camera)
            .part(options_.backend)
            .text();
    }

    static Yardstick parsed_yardstick(const std::string& text) {
        const std::size_t equals = text.find('=');
        const auto error =
            equals == std::string::npos ? std::nullopt : parsed_number(text.substr(equals + 1));
        if (!error || !(*error > 0)) {
            throw Error("--at " + text + ": write METRIC=ERROR with an error above 0, flip=0.05");
        }
        const Metric& metric = find_metric(text.substr(0, equals));
        if (metric.higher_is_better) {
            throw Error(fmt::format("--at {}: {} rises with quality; name an error, rmse=0.05",
                                    text, metric.label));
        }
        return {&metric, *error};
    }

    /// The file's name without its ending; with a number when two scenes are called the same.
    static std::string unused_name(const LabReport& report, const std::string& file) {
        const std::string stem = std::filesystem::path(file).stem().string();
        const auto used = [&](const std::string& name) {
            return std::any_of(report.scenes.begin(), report.scenes.end(),
                               [&](const SceneReport& scene) { return scene.scene == name; });
        };
        std::string name = stem;
        for (int n = 2; used(name); ++n) name = fmt::format("{}-{}", stem, n);
        return name;
    }

    static bool all_finite_in(const LabReport& report) {
        for (const SceneReport& scene : report.scenes) {
            for (const LabSeries& series : scene.series) {
                for (const LabPoint& point : series.points) {
                    if (point.errors.non_finite.count > 0) return false;
                }
            }
        }
        return true;
    }

    /// What makes this report again.
    [[nodiscard]] std::string command() const {
        std::string text = "luch lab";
        const auto add = [&](const std::string& word) {
            text += ' ';
            text += shell_word(word);
        };
        const auto add_option = [&](const std::string& option, const std::string& value) {
            if (value.empty()) return;
            add(option);
            add(value);
        };
        for (const std::string& scene : scenes_) add(scene);
        for (const std::string& list : techniques_) add_option("-t", list);
        if (quick_) add("--quick");
        add_option("--at", at_);
        add_option("--size", options_.size);
        if (options_.threads != 0) add_option("--threads", std::to_string(options_.threads));
        if (options_.seed != 0) add_option("--seed", std::to_string(options_.seed));
        add_option("--camera", options_.camera);
        add_option("--root", options_.root);
        if (options_.strict) add("--strict");
        if (options_.no_skip) add("--no-skip");
        if (options_.backend != "luch") add_option("--backend", options_.backend);
        add_option("--cache", cache_);
        if (out_ != "out/lab") add_option("--out", out_);
        return text;
    }

    std::vector<std::string> scenes_, techniques_;
    std::string out_ = "out/lab";
    std::string at_, cache_;
    bool quick_ = false, fresh_ = false;
    SceneOptions options_;
};

}  // namespace

std::unique_ptr<Verb> make_lab() {
    return std::make_unique<Lab>();
}

}  // namespace luch
