#include "framework/measure/bench_raster.h"

#include "framework/accel/embree.h"
#include "framework/measure/metrics.h"
#include "framework/raster/item_buffer.h"

#include <chrono>
#include <ctime>
#include <functional>
#include <numbers>
#include <optional>

namespace luch {
namespace {

constexpr int tiles_of_chunk = 16;

struct Contender {
    std::string backend, mode;
    std::function<void()> reset, run;
    std::vector<double> seconds{};
};

/// The mesh, the frame, and what was found in it tile by tile.
struct Arena {
    Scene scene;
    std::unique_ptr<Accelerator> accelerator;
    std::optional<ItemBuffer> buffer;
    std::optional<Screen> screen;
    std::vector<RayPacket> rays;
    std::vector<HitPacket> hits;
    std::vector<WorkCounts> work;
};

/// Sixty degrees high, as the camera of bench rays.
Camera camera_of(const BenchView& view, Size size) {
    const Vec3d ahead = glm::normalize(view.at - view.eye);
    Camera camera;
    camera.position = view.eye;
    camera.yaw_deg = -std::atan2(ahead.x, ahead.z) * 180 / std::numbers::pi;
    camera.pitch_deg = std::asin(ahead.y) * 180 / std::numbers::pi;
    camera.aspect = static_cast<double>(size.width) / size.height;
    const double diagonal = std::sqrt(camera.aspect * camera.aspect + 1) / std::numbers::sqrt3;
    camera.fov_deg = 2 * std::atan(diagonal) * 180 / std::numbers::pi;
    return camera;
}

void prepare(Arena& arena, const Mesh& mesh, const BenchView& view, const RasterBench& bench) {
    Mesh raw = mesh;
    raw.from_frame = {};
    arena.scene.geometries.emplace_back(std::move(raw));
    arena.scene.materials.emplace_back(Lambert{});
    add_node(arena.scene, "mesh", 0, 0, {});
    arena.scene.camera = camera_of(view, bench.size);
    arena.accelerator = build_accelerator(arena.scene, bench.isa);
    arena.buffer.emplace(arena.scene, bench.isa);
    arena.screen.emplace(arena.scene.camera, bench.size);
    arena.buffer->draw(*arena.screen, Vec2d(0.5), Workers(bench.threads));
    for (int i = 0; i < arena.buffer->tile_count(); ++i) {
        arena.rays.push_back(arena.buffer->rays(i));
    }
    arena.hits.resize(arena.rays.size());
    arena.work.resize(arena.rays.size());
}

void for_each_tile(const Arena& arena, const Workers& workers,
                   const std::function<void(std::size_t)>& work) {
    const auto tiles = static_cast<int>(arena.rays.size());
    workers.for_each((tiles + tiles_of_chunk - 1) / tiles_of_chunk, [&](int chunk, int) {
        for (int i = chunk * tiles_of_chunk; i < std::min(tiles, (chunk + 1) * tiles_of_chunk);
             ++i) {
            work(static_cast<std::size_t>(i));
        }
    });
}

std::vector<Contender> own_contenders(Arena& arena, const Workers& workers) {
    const auto draw = [&] { arena.buffer->draw(*arena.screen, Vec2d(0.5), workers); };
    const auto resolve = [&](std::size_t i) {
        const auto tile = static_cast<int>(i);
        HitPacket& hits = arena.hits[i];
        if (arena.buffer->resolve(tile, arena.rays[i], hits) == 0) return;
        arena.buffer->trace_ambiguous(tile, arena.rays[i], *arena.accelerator, hits, arena.work[i]);
    };
    const auto shoot = [&](std::size_t i) {
        arena.accelerator->closest(arena.rays[i], arena.hits[i], arena.work[i]);
    };
    // What a renderer does: a tile's rays are made when they are needed, its hits are used at once.
    const auto make_and_resolve = [&](std::size_t i) {
        const auto tile = static_cast<int>(i);
        const RayPacket rays = arena.buffer->rays(tile);
        HitPacket hits;
        if (arena.buffer->resolve(tile, rays, hits) == 0) return;
        arena.buffer->trace_ambiguous(tile, rays, *arena.accelerator, hits, arena.work[i]);
    };
    const auto make_and_shoot = [&](std::size_t i) {
        HitPacket hits;
        arena.accelerator->closest(arena.buffer->rays(static_cast<int>(i)), hits, arena.work[i]);
    };
    return {{"luch", "ids", [] {}, draw},
            {"luch", "packets", [] {}, [&, shoot] { for_each_tile(arena, workers, shoot); }},
            {"luch", "ids+resolve", [] {},
             [&, draw, resolve] {
                 draw();
                 for_each_tile(arena, workers, resolve);
             }},
            {"luch", "frame: packets", [] {},
             [&, make_and_shoot] { for_each_tile(arena, workers, make_and_shoot); }},
            {"luch", "frame: ids+resolve", [] {},
             [&, draw, make_and_resolve] {
                 draw();
                 for_each_tile(arena, workers, make_and_resolve);
             }}};
}

void add_embree(std::vector<Contender>& contenders, const Arena& arena, const EmbreeScene& embree,
                const Workers& workers) {
    std::vector<Ray> rays;
    for (const RayPacket& packet : arena.rays) {
        for (int i = 0; i < packet.count; ++i) rays.push_back(packet.ray(i));
    }
    for (std::size_t mode = 0; mode < embree_mode_names.size(); ++mode) {
        const std::shared_ptr<EmbreeScene::Batch> batch =
            embree.batch(rays, static_cast<EmbreeMode>(mode), true);
        const std::size_t n = rays.size();
        constexpr std::size_t chunk = tiles_of_chunk * RayPacket::capacity;
        contenders.push_back(
            {"embree", std::string(embree_mode_names[mode]), [batch] { batch->reset(); },
             [batch, n, &workers] {
                 workers.for_each(static_cast<int>((n + chunk - 1) / chunk), [&](int i, int) {
                     const auto first = static_cast<std::size_t>(i) * chunk;
                     batch->shoot(first, std::min(n, first + chunk), false);
                 });
             }});
    }
}

/// What one thread needs is told by its own clock, which others on the machine do not disturb.
double seconds_of(int threads, const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    work();
    if (threads == 1) return static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void count_pixels(const Arena& arena, RasterSpeed& speed) {
    WorkCounts work;
    speed.ambiguous = arena.buffer->ambiguous_count();
    for (std::size_t i = 0; i < arena.rays.size(); ++i) {
        for (int k = 0; k < RayPacket::capacity; ++k) {
            const Ray ray = arena.rays[i].ray(k);
            if (!(ray.t_max > ray.t_min)) continue;
            const Hit truth = arena.accelerator->closest(ray, work);
            speed.mismatches += arena.hits[i].hit(k) == truth ? 0 : 1;
            speed.covered += truth ? 1 : 0;
        }
    }
}

}  // namespace

double RasterSpeed::ratio_of(const RasterModeSpeed& mode) const {
    double best = 0, packets = 1;
    for (const RasterModeSpeed& each : modes) {
        if (each.backend == "embree") best = std::max(best, each.mpixels_per_s);
        if (each.mode == "packets") packets = each.mpixels_per_s;
    }
    return mode.mpixels_per_s / (best > 0 ? best : packets);
}

RasterSpeed raced(const std::string& name, const Mesh& mesh, const BenchView& view,
                  const RasterBench& bench) {
    const Workers workers(bench.threads);
    Arena arena;
    prepare(arena, mesh, view, bench);
    std::optional<EmbreeScene> embree;
    std::vector<Contender> contenders = own_contenders(arena, workers);
    if (bench.embree) {
        embree.emplace(mesh, 1.0f, false, bench.isa);
        add_embree(contenders, arena, *embree, workers);
    }
    for (int round = -1; round < bench.rounds; ++round) {  // the first one warms up
        for (Contender& each : contenders) {
            each.reset();
            const double seconds = seconds_of(bench.threads, each.run);
            if (round >= 0) each.seconds.push_back(seconds);
        }
    }
    RasterSpeed speed{name, mesh.triangles.size(), {}, bench.size.area(), 0, 0, 0};
    for (const Contender& each : contenders) {
        speed.modes.push_back({each.backend, each.mode,
                               1e-6 * static_cast<double>(speed.pixels) / median(each.seconds)});
    }
    count_pixels(arena, speed);
    return speed;
}

}  // namespace luch
