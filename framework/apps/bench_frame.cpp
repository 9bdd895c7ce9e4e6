#include "framework/measure/bench_frame.h"

#include "framework/accel/embree.h"
#include "framework/apps/bench_options.h"
#include "framework/apps/session.h"
#include "framework/measure/report_json.h"

#include <fmt/format.h>

namespace luch {
namespace {

std::string_view name_of(Backend backend) {
    return backend == Backend::luch ? "luch" : "embree";
}

FrameBench asked_for(const BenchOptions& options) {
    FrameBench bench{.rounds = options.rays.rounds, .isa = options.rays.isa};
    if (!options.any_threads) bench.threads = {options.rays.threads};
    bench.backends.clear();
    for (const std::string& name : options.rays.backends) {
        bench.backends.push_back(parsed_backend(name));
    }
    if (options.any_backend && has_embree()) bench.backends.push_back(Backend::embree);
    return bench;
}

void print(const std::vector<FrameSpeed>& speeds) {
    for (const FrameSpeed& speed : speeds) {
        fmt::print("  {:<7} {:3} threads {:10.1f} ms CPU {:10.1f} ms {:8} pixels differ\n",
                   name_of(speed.backend), speed.threads, speed.cpu_ms, speed.wall_ms,
                   speed.different_pixels);
    }
    const Counts& counts = speeds[0].counts;
    const auto all = static_cast<double>(std::max<std::uint64_t>(1, counts.all_rays()));
    fmt::print("  rays:");
    for (std::size_t i = 0; i < ray_kind_names.size(); ++i) {
        if (counts.rays[i] == 0) continue;
        fmt::print(" {} {} ({:.1f} %)", ray_kind_names[i], counts.rays[i],
                   100 * static_cast<double>(counts.rays[i]) / all);
    }
    fmt::print("; {} shades; {:.2f} Mray a CPU second\n", counts.shades,
               1e-3 * all / speeds[0].cpu_ms);
}

Json json_of(const std::vector<FrameSpeed>& speeds) {
    Json frames = Json::array();
    for (const FrameSpeed& speed : speeds) {
        frames.push(Json::object()
                        .set("backend", name_of(speed.backend))
                        .set("threads", speed.threads)
                        .set("cpu_ms", speed.cpu_ms)
                        .set("frame_ms", speed.wall_ms)
                        .set("different_pixels", speed.different_pixels)
                        .set("rays", rays_json(speed.counts))
                        .set("shades", speed.counts.shades)
                        .set("boxes", speed.counts.work.boxes)
                        .set("primitives", speed.counts.work.primitives));
    }
    return frames;
}

}  // namespace

int bench_frame(const BenchOptions& options) {
    const FrameBench bench = asked_for(options);
    Json scenes = Json::array();
    for (const std::string& name : options.inputs) {
        const Session session(name, {});
        Shot shot = session.shot();
        shot.size = options.size(shot.size);
        const auto speeds = raced(session.scene(), shot, find_technique("baseline"), bench);
        fmt::print("{}, {} x {} pixels, {}\n", name, shot.size.width, shot.size.height,
                   to_string(bench.isa));
        print(speeds);
        scenes.push(Json::object()
                        .set("scene", name)
                        .set("width", shot.size.width)
                        .set("height", shot.size.height)
                        .set("frames", json_of(speeds)));
    }
    options.write(Json::object().set("isa", to_string(bench.isa)).set("scenes", scenes));
    return 0;
}

}  // namespace luch
