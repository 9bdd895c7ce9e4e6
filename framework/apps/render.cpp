#include "framework/apps/progress.h"
#include "framework/apps/ray_log.h"
#include "framework/apps/session.h"
#include "framework/apps/verbs.h"
#include "framework/base/error.h"
#include "framework/base/json.h"
#include "framework/image/io.h"
#include "framework/measure/report_json.h"

#include <fmt/format.h>

#include <filesystem>

namespace luch {
namespace {

class Render final : public Verb {
 public:
    std::string_view name() const override { return "render"; }
    std::string_view summary() const override { return "make a picture of a scene"; }
    std::string_view examples() const override {
        return "  luch render scenes/room/room.scene                      writes out/room.png\n"
               "  luch render scenes/room/room.scene -t vista -o room.exr  linear, half float\n"
               "  luch render scenes/room/room.scene --spp 16 --json room.json\n"
               "  luch render scenes/spheres/spheres.scene -t vista -p segments=16\n"
               "  luch render scenes/room/room.scene --ray-log 470,300     and that pixel's rays\n";
    }
    void declare(Arguments& arguments) override {
        arguments.positional("SCENE", scene_, "a scene file");
        arguments.option("-t,--technique", technique_, "NAME",
                         "what renders it [path where the scene says gi, else baseline]");
        arguments.option("-p,--param", params_, "KEY=VALUE", "a parameter of the technique");
        arguments.option("-o,--output", output_, "FILE",
                         ".png .bmp .jpg (sRGB), .exr .hdr (linear) [out/SCENE.png]");
        arguments.option("--frames", frames_, "N", "time N frames, report the median [1]");
        arguments.option("--json", json_, "FILE",
                         "write times, rays and what was left out as JSON");
        ray_log_.declare(arguments);
        options_.declare(arguments);
    }
    int run() override {
        if (frames_ < 1 || frames_ > 1000) throw Error("--frames: give 1 to 1000");
        const Session session(scene_, options_);
        if (technique_.empty()) technique_ = default_technique(session.scene());
        const auto technique = make_technique(technique_, params_);
        RayLog log;
        const auto watch = ray_log_.watch(session.shot().size, log);
        if (watch && frames_ > 1) throw Error("--ray-log records one frame; leave --frames out");
        Progress progress;
        Budget budget = session.budget();
        budget.planes = false;
        // A log of a program's output wants no line for each part of a picture.
        if (progress.on_terminal()) {
            budget.on_part = [&](double part) { progress.step(part, scene_); };
        }
        const Outcome outcome =
            luch::run(*technique, session.studio(), session.shot(), budget,
                      {.warm_up = frames_ > 1 ? 1 : 0, .frames = frames_}, nullptr, watch);
        progress.clear();
        if (!outcome.plan.applies) {
            throw Error(technique_ + " does not apply to this scene: " + outcome.plan.why);
        }
        const std::filesystem::path output =
            output_.empty() ? "out/" + std::filesystem::path(scene_).stem().string() + ".png"
                            : output_;
        write_picture(output, outcome.frame.colour.view());
        report(session, outcome, output);
        if (watch) write_ray_log(session, ray_log_, *watch, output);
        if (!json_.empty()) json_of(session, outcome).write(json_);
        return outcome.non_finite.count == 0 ? 0 : 1;
    }

 private:
    void report(const Session& session, const Outcome& outcome,
                const std::filesystem::path& output) const {
        fmt::print(
            "{} {}×{}, {}: {:.1f} ms (cpu {:.1f} ms, {} threads; load {:.1f} ms, build "
            "{:.1f} ms)\n",
            scene_, session.shot().size.width, session.shot().size.height, technique_,
            median(outcome.frame_ms), median(outcome.cpu_ms), outcome.threads, session.load_ms(),
            session.build_ms());
        fmt::print("rays");
        for (std::size_t i = 0; i < ray_kind_names.size(); ++i) {
            if (outcome.counts.rays[i] == 0) continue;
            fmt::print(" {} {}", ray_kind_names[i], outcome.counts.rays[i]);
        }
        fmt::print("\n");
        for (const std::string& task : outcome.unwritten) {
            fmt::print("{} is still to be written; what stood in is not yours\n", task);
        }
        if (outcome.non_finite.count > 0) {
            fmt::print("{} pixels are not finite, the first at ({}, {})\n",
                       outcome.non_finite.count, outcome.non_finite.first_x,
                       outcome.non_finite.first_y);
        }
        fmt::print("{}\n", output.string());
    }

    Json json_of(const Session& session, const Outcome& outcome) const {
        return Json::object()
            .set("version", LUCH_VERSION)
            .set("technique", technique_)
            .set("scene", scene_)
            .set("size",
                 Json::array().push(session.shot().size.width).push(session.shot().size.height))
            .set("threads", outcome.threads)
            .set("spp", session.shot().spp)
            .set("seed", session.shot().seed)
            .set("load_ms", session.load_ms())
            .set("build_ms", session.build_ms())
            .set("prepare_ms", outcome.prepare_ms)
            .set("frame_ms", median(outcome.frame_ms))
            .set("cpu_ms", median(outcome.cpu_ms))
            .set("frames", static_cast<int>(outcome.frame_ms.size()))
            .set("rays", rays_json(outcome.counts))
            .set("object_tests", outcome.counts.object_tests)
            .set("shades", outcome.counts.shades)
            .set("fallbacks", outcome.counts.fallbacks)
            .set("boxes", outcome.counts.work.boxes)
            .set("primitives", outcome.counts.work.primitives)
            .set("bytes", outcome.bytes)
            .set("left_out", left_out_json(outcome.plan))
            .set("non_finite_pixels", outcome.non_finite.count);
    }

    std::string scene_, technique_, output_, json_;
    std::vector<std::string> params_;
    int frames_ = 1;
    SceneOptions options_;
    RayLogOptions ray_log_;
};

}  // namespace

std::unique_ptr<Verb> make_render() {
    return std::make_unique<Render>();
}

}  // namespace luch
