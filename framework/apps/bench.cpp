#include "framework/accel/embree.h"
#include "framework/apps/verbs.h"
#include "framework/base/error.h"
#include "framework/base/json.h"
#include "framework/base/text.h"
#include "framework/measure/bench_raster.h"
#include "framework/measure/bench_rays.h"
#include "framework/scene/loader/mesh_builder.h"
#include "framework/scene/loader/obj.h"

#include <fmt/format.h>

#include <numbers>

namespace luch {
namespace {

/// A closed surface of 2²⁰ triangles with bumps of several sizes, for when no mesh of that size is
/// at hand.
Mesh bumpy_sphere() {
    constexpr int rings = 512, segments = 1024;
    std::vector<Vec3d> positions;
    for (int ring = 0; ring <= rings; ++ring) {
        for (int segment = 0; segment < segments; ++segment) {
            const double theta = std::numbers::pi * ring / rings;
            const double phi = 2 * std::numbers::pi * segment / segments;
            const double bumps = std::sin(7 * theta) * std::cos(5 * phi) +
                                 0.3 * std::sin(41 * theta + 3) * std::sin(37 * phi) +
                                 0.05 * std::sin(201 * theta) * std::cos(199 * phi);
            const double radius = 1 + 0.1 * bumps * std::sin(theta);
            positions.emplace_back(radius * std::sin(theta) * std::cos(phi),
                                   radius * std::cos(theta),
                                   radius * std::sin(theta) * std::sin(phi));
        }
    }
    Mesh mesh;
    set_positions(mesh, positions);
    for (std::uint32_t i = 0; i < rings * segments; ++i) {
        const std::uint32_t next = i / segments * segments + (i + 1) % segments;
        mesh.triangles.push_back({.position = {i, next, i + segments}, .normal = {}, .uv = {}});
        mesh.triangles.push_back(
            {.position = {next, next + segments, i + segments}, .normal = {}, .uv = {}});
    }
    return mesh;
}

Mesh mesh_of(const std::string& name) {
    if (name == "bumpy") return bumpy_sphere();
    if (!std::filesystem::is_regular_file(name)) {
        throw Error(name + ": there is no such file; give an .obj, or bumpy for a generated mesh");
    }
    loader::Diagnostics diagnostics(name, false);
    return loader::mesh_of(loader::read_obj(name, diagnostics), {}, name);
}

/// "x,y,z,x,y,z,x,y,z": eye, at and light in the file's coordinates; "": outside, for any mesh.
BenchView view_of(const std::string& text, const Mesh& mesh) {
    if (text.empty()) {
        const Boxd box = bounds_of(mesh);
        const double radius = 0.5 * glm::length(box.size());
        return {box.centre() + 1.75 * radius * glm::normalize(Vec3d(0.5, 0.35, 1)), box.centre(),
                box.centre() + 2.5 * radius * glm::normalize(Vec3d(-0.8, 1, 0.8))};
    }
    std::vector<double> numbers;
    for (const std::string& word : split(text, ',')) {
        const auto number = parsed_number(word);
        if (number) numbers.push_back(*number);
    }
    if (numbers.size() != 9) {
        throw Error("--view " + text +
                    ": give nine numbers, x,y,z of the eye, of what it looks "
                    "at, and of the light");
    }
    const Transform to_frame = mesh.from_frame.inverse();
    const auto point = [&](int i) {
        return to_frame.point({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]});
    };
    return {point(0), point(1), point(2)};
}

std::vector<std::string> checked(const std::string& text, const std::string& option,
                                 std::span<const std::string_view> known) {
    std::vector<std::string> words = split(text, ',');
    for (const std::string& word : words) {
        if (std::ranges::find(known, word) != known.end()) continue;
        throw Error(option + " " + word + ": " + did_you_mean(word, known));
    }
    return words;
}

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

void print(const RasterSpeed& speed) {
    fmt::print("{}: {} triangles, {} pixels, {} of them covered\n", speed.mesh, speed.triangles,
               speed.pixels, speed.covered);
    for (const RasterModeSpeed& mode : speed.modes) {
        fmt::print("  {:<7} {:<12} {:8.2f} Mpx/s {:6.2f} x\n", mode.backend, mode.mode,
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

class Bench final : public Verb {
 public:
    std::string_view name() const override { return "bench"; }
    std::string_view summary() const override { return "how fast rays are, beside a peer"; }
    std::string_view examples() const override {
        return "  luch bench rays scenes/room/teapot_hires.obj\n"
               "  luch bench rays bumpy --backend luch,embree --rays primary,shadow\n"
               "  luch bench raster bumpy --backend luch,embree --width 1280 --height 720\n";
    }
    void declare(Arguments& arguments) override {
        arguments.positional("WHAT", what_, "rays or raster");
        arguments.positional("MESH", meshes_, "meshes: .obj files, or bumpy (generated)");
        arguments.option("--backend", backends_, "NAMES", "luch, or luch,embree to race them");
        arguments.option("--rays", kinds_, "KINDS", "of primary, shadow and diffuse");
        arguments.option("--threads", bench_.threads, "N", "threads, 0: one a core [1]");
        arguments.option("--isa", isa_, "LEVEL", "v2, v3 or v4, for all back ends [the best]");
        arguments.option("--side", bench_.side, "N", "N x N rays of a kind [1024]");
        arguments.option("--width", size_.width, "N", "of the frame of bench raster [1920]");
        arguments.option("--height", size_.height, "N", "of the frame of bench raster [1080]");
        arguments.option("--rounds", bench_.rounds, "N", "medians of so many runs [7]");
        arguments.option("--scale", bench_.scale, "X", "size of the mesh, a power of two [1]");
        arguments.option("--view", view_, "NUMBERS", "eye, target, light: nine numbers");
        arguments.option("--json", json_, "FILE", "write the speeds as JSON");
    }
    int run() override {
        check();
        if (what_ == "raster") return run_raster();
        Json meshes = Json::array();
        std::uint64_t mismatches = 0;
        for (const std::string& name : meshes_) {
            const Mesh mesh = mesh_of(name);
            const MeshSpeed speed = raced(name, mesh, view_of(view_, mesh), bench_);
            print(speed, bench_);
            print_ratios(speed, bench_);
            meshes.push(json_of(speed, bench_));
            for (const RayKindSpeed& kind : speed.kinds) mismatches += kind.hit_mismatches;
        }
        if (!json_.empty()) {
            Json::object()
                .set("version", LUCH_VERSION)
                .set("threads", bench_.threads)
                .set("isa", to_string(bench_.isa))
                .set("side", bench_.side)
                .set("scale", bench_.scale)
                .set("meshes", meshes)
                .write(json_);
        }
        return mismatches == 0 ? 0 : 1;
    }

 private:
    int run_raster() {
        const RasterBench bench{std::ranges::count(bench_.backends, "embree") > 0, bench_.threads,
                                size_, bench_.rounds, bench_.isa};
        Json meshes = Json::array();
        std::uint64_t mismatches = 0;
        for (const std::string& name : meshes_) {
            const Mesh mesh = mesh_of(name);
            const RasterSpeed speed = raced(name, mesh, view_of(view_, mesh), bench);
            print(speed);
            meshes.push(json_of(speed));
            mismatches += speed.mismatches;
        }
        if (!json_.empty()) {
            Json::object()
                .set("version", LUCH_VERSION)
                .set("threads", bench.threads)
                .set("isa", to_string(bench.isa))
                .set("width", size_.width)
                .set("height", size_.height)
                .set("meshes", meshes)
                .write(json_);
        }
        return mismatches == 0 ? 0 : 1;
    }

    void check() {
        constexpr std::string_view whats[] = {"rays", "raster"}, backends[] = {"luch", "embree"},
                                   kinds[] = {"primary", "shadow", "diffuse"};
        checked(what_, "bench", whats);
        bench_.backends = checked(backends_, "--backend", backends);
        bench_.kinds = checked(kinds_, "--rays", kinds);
        bench_.isa = parsed_isa(isa_);
        if (std::ranges::count(bench_.backends, "embree") > 0 && !has_embree()) {
            throw Error("--backend embree: this build has no Embree; install libembree-dev");
        }
        if (bench_.threads < 0 || bench_.threads > 1024) {
            throw Error(fmt::format("--threads {}: give 0 to 1024", bench_.threads));
        }
        if (bench_.side < 16 || bench_.side > 8192 || bench_.side % 16 != 0) {
            throw Error(fmt::format("--side {}: give a multiple of 16, to 8192", bench_.side));
        }
        if (std::min(size_.width, size_.height) < 1 || std::max(size_.width, size_.height) > 8192) {
            throw Error(fmt::format("--width {} --height {}: give 1 to 8192 for each", size_.width,
                                    size_.height));
        }
        if (bench_.rounds < 1 || bench_.rounds > 1000) {
            throw Error(fmt::format("--rounds {}: give 1 to 1000", bench_.rounds));
        }
        if (!(bench_.scale > 0) || std::exp2(std::round(std::log2(bench_.scale))) != bench_.scale) {
            throw Error(fmt::format("--scale {}: give a power of two", bench_.scale));
        }
    }

    std::string what_, isa_, view_, json_, backends_ = "luch", kinds_ = "primary,shadow,diffuse";
    std::vector<std::string> meshes_;
    RayBench bench_;
    Size size_{1920, 1080};
};

}  // namespace

std::unique_ptr<Verb> make_bench() {
    return std::make_unique<Bench>();
}

}  // namespace luch
