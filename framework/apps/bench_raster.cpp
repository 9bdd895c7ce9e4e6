#include "framework/measure/bench_raster.h"

#include "framework/apps/bench_options.h"

#include <fmt/format.h>

namespace luch {
namespace {

void print(const RasterSpeed& speed) {
    fmt::print("{}: {} triangles, {} pixels, {} of them covered\n", speed.mesh, speed.triangles,
               speed.pixels, speed.covered);
    for (const RasterModeSpeed& mode : speed.modes) {
        fmt::print("  {:<7} {:<18} {:8.2f} Mpx/s {:6.2f} x\n", mode.backend, mode.mode,
                   mode.mpixels_per_s, speed.ratio_of(mode));
    }
    fmt::print("  {} ambiguous pixels traced; {} pixels differ from the single ray\n",
               speed.ambiguous, speed.mismatches);
}

Json json_of(const RasterSpeed& speed) {
    Json modes = Json::array();
    for (const RasterModeSpeed& mode : speed.modes) {
        modes.push(Json::object()
                       .set("backend", mode.backend)
                       .set("mode", mode.mode)
                       .set("mpixels_per_s", mode.mpixels_per_s)
                       .set("ratio", speed.ratio_of(mode)));
    }
    return Json::object()
        .set("mesh", speed.mesh)
        .set("triangles", speed.triangles)
        .set("pixels", speed.pixels)
        .set("covered", speed.covered)
        .set("ambiguous", speed.ambiguous)
        .set("mismatches", speed.mismatches)
        .set("modes", modes);
}

}  // namespace

int bench_raster(const BenchOptions& options) {
    const RasterBench bench{std::ranges::count(options.rays.backends, "embree") > 0,
                            options.rays.threads, options.size({1920, 1080}), options.rays.rounds,
                            options.rays.isa};
    Json meshes = Json::array();
    std::uint64_t mismatches = 0;
    for (const std::string& name : options.inputs) {
        const Mesh mesh = mesh_of(name);
        const RasterSpeed speed = raced(name, mesh, view_of(options.view, mesh), bench);
        print(speed);
        meshes.push(json_of(speed));
        mismatches += speed.mismatches;
    }
    options.write(Json::object()
                      .set("threads", bench.threads)
                      .set("isa", to_string(bench.isa))
                      .set("width", bench.size.width)
                      .set("height", bench.size.height)
                      .set("meshes", meshes));
    return mismatches == 0 ? 0 : 1;
}

}  // namespace luch
