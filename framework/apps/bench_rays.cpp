#include "framework/measure/bench_rays.h"

#include "framework/apps/bench_options.h"

#include <fmt/format.h>

namespace luch {
namespace {

void print(const MeshSpeed& speed, const RayBench& bench) {
    fmt::print("{}: {} triangles; build", speed.mesh, speed.triangles);
    for (std::size_t i = 0; i < speed.build_cpu_ms.size(); ++i) {
        fmt::print(" {} {:.1f} ms CPU", bench.backends[i], speed.build_cpu_ms[i]);
    }
    fmt::print("\n");
    for (const RayKindSpeed& kind : speed.kinds) {
        fmt::print("  {:<8} {:<7}", kind.kind, kind.backend);
        for (const RayModeSpeed& mode : kind.modes) {
            fmt::print(" {} {:.2f}", mode.mode, mode.mrays_per_s);
            if (mode.boxes > 0) {
                fmt::print(" ({:.1f} boxes, {:.1f} triangles)", mode.boxes, mode.primitives);
            }
        }
        fmt::print(" Mray/s\n");
    }
}

/// A back end's speed as a multiple of the first one's.
void print_ratios(const MeshSpeed& speed, const RayBench& bench) {
    const std::size_t backends = bench.backends.size();
    for (std::size_t i = 0; i < speed.kinds.size(); ++i) {
        const RayKindSpeed &first = speed.kinds[i - i % backends], &kind = speed.kinds[i];
        if (i % backends == 0) continue;
        fmt::print(
            "  {:<8} {} / {}: best {:.2f}, single {:.2f}; {} hits differ, {} within rounding; same "
            "triangle {:.4f} %, {} nearer or farther\n",
            kind.kind, first.backend, kind.backend,
            first.best().mrays_per_s / kind.best().mrays_per_s,
            first.speed_of("single") / kind.speed_of("single"), kind.hit_mismatches,
            kind.hit_doubts, 100 * kind.prim_agreement, kind.prim_mismatches);
    }
}

Json json_of(const MeshSpeed& speed, const RayBench& bench) {
    Json kinds = Json::array();
    for (std::size_t i = 0; i < speed.kinds.size(); ++i) {
        const RayKindSpeed& kind = speed.kinds[i];
        const RayKindSpeed& first = speed.kinds[i - i % bench.backends.size()];
        Json modes = Json::object();
        for (const RayModeSpeed& mode : kind.modes) modes.set(mode.mode, mode.mrays_per_s);
        kinds.push(Json::object()
                       .set("kind", kind.kind)
                       .set("backend", kind.backend)
                       .set("rays", kind.rays)
                       .set("mode", kind.best().mode)
                       .set("mrays_per_s", kind.best().mrays_per_s)
                       .set("ratio", kind.best().mrays_per_s / first.best().mrays_per_s)
                       .set("single_ratio", kind.speed_of("single") / first.speed_of("single"))
                       .set("modes", modes)
                       .set("hit_mismatches", kind.hit_mismatches)
                       .set("hit_doubts", kind.hit_doubts)
                       .set("prim_agreement", kind.prim_agreement)
                       .set("prim_mismatches", kind.prim_mismatches));
    }
    Json builds = Json::object();
    for (std::size_t i = 0; i < bench.backends.size(); ++i) {
        builds.set(bench.backends[i], speed.build_cpu_ms[i]);
    }
    return Json::object()
        .set("mesh", speed.mesh)
        .set("triangles", speed.triangles)
        .set("build_cpu_ms", builds)
        .set("kinds", kinds);
}

}  // namespace

int bench_rays(const BenchOptions& options) {
    const RayBench& bench = options.rays;
    Json meshes = Json::array();
    std::uint64_t mismatches = 0;
    for (const std::string& name : options.inputs) {
        const Mesh mesh = mesh_of(name);
        const MeshSpeed speed = raced(name, mesh, view_of(options.view, mesh), bench);
        print(speed, bench);
        print_ratios(speed, bench);
        meshes.push(json_of(speed, bench));
        for (const RayKindSpeed& kind : speed.kinds) mismatches += kind.hit_mismatches;
    }
    options.write(Json::object()
                      .set("threads", bench.threads)
                      .set("isa", to_string(bench.isa))
                      .set("side", bench.side)
                      .set("scale", bench.scale)
                      .set("meshes", meshes));
    return mismatches == 0 ? 0 : 1;
}

}  // namespace luch
