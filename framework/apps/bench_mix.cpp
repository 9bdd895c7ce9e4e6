#include "framework/measure/bench_mix.h"

#include "framework/apps/bench_options.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch {
namespace {

/// Half a level of 255, which rounding costs, and what floats make of it.
constexpr double most_error = 0.5001;

}  // namespace

int bench_mix(const BenchOptions& options) {
    const MixBench bench{options.size({1920, 1080}), options.rays.rounds, options.rays.isa};
    const std::vector<MixSpeed> speeds = raced(bench);
    fmt::print(
        "{} x {} pixels, one thread, {}; × as fast as floats: frames (other work before), "
        "again (what the caches kept), tiles\n",
        bench.size.width, bench.size.height, to_string(bench.isa));
    Json modes = Json::array();
    bool right = true;
    for (const MixSpeed& speed : speeds) {
        const MixSpeed& floats = *std::ranges::find(speeds, speed.against, &MixSpeed::mode);
        const double gb_per_s = speed.bytes_per_pixel / speed.frame_ns;
        const double frame_ratio = floats.frame_ns / speed.frame_ns;
        const double again_ratio = floats.again_ns / speed.again_ns;
        const double tile_ratio = floats.tile_ns / speed.tile_ns;
        fmt::print(
            "  {:<14} {:3} B/px  frame {:6.3f} ns/px {:5.1f} GB/s {:5.2f} x   again {:6.3f} "
            "{:5.2f} "
            "x   tile {} {:6.3f} {:5.2f} x   worst error {:.2f}/255\n",
            speed.mode, speed.bytes_per_pixel, speed.frame_ns, gb_per_s, frame_ratio,
            speed.again_ns, again_ratio, speed.tile_side, speed.tile_ns, tile_ratio,
            speed.worst_error);
        modes.push(Json::object()
                       .set("mode", speed.mode)
                       .set("against", speed.against)
                       .set("bytes_per_pixel", speed.bytes_per_pixel)
                       .set("frame_ns_per_pixel", speed.frame_ns)
                       .set("frame_gb_per_s", gb_per_s)
                       .set("frame_ratio", frame_ratio)
                       .set("again_ns_per_pixel", speed.again_ns)
                       .set("again_ratio", again_ratio)
                       .set("tile_side", speed.tile_side)
                       .set("tile_ns_per_pixel", speed.tile_ns)
                       .set("tile_ratio", tile_ratio)
                       .set("worst_error", speed.worst_error));
        right = right && speed.worst_error <= most_error;
    }
    options.write(Json::object()
                      .set("isa", to_string(bench.isa))
                      .set("width", bench.size.width)
                      .set("height", bench.size.height)
                      .set("modes", modes));
    return right ? 0 : 1;
}

}  // namespace luch
