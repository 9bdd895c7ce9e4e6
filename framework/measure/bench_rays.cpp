#include "framework/measure/bench_rays.h"

#include "framework/accel/embree.h"
#include "framework/measure/bench_judge.h"
#include "framework/measure/bench_shots.h"
#include "framework/measure/metrics.h"
#include "framework/parallel/workers.h"
#include "framework/scene/scene.h"

#include <chrono>
#include <ctime>
#include <functional>

namespace luch {
namespace {

/// What a thread takes at once, and what back ends do in turn: milliseconds, so that what else the
/// machine does meets all of them, but much more than a cache holds.
constexpr int chunk = 4096, chunks_in_turn = 16;

/// One way to shoot the rays: chunk i of them, after a reset.
struct Contender {
    std::string backend, mode;
    std::function<void()> reset;
    std::function<void(int i)> shoot;
    std::vector<std::vector<double>> seconds{};  ///< of every turn's rays, by rounds
    WorkCounts work{};                           ///< luch's alone
};

double cpu_seconds_of(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// What one thread needs is told by its own clock, which others on the machine do not disturb.
double seconds_of(int threads, const std::function<void()>& work) {
    if (threads == 1) return cpu_seconds_of(work);
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Luch's own scene with the mesh in it, and what its rays met.
struct Own {
    Scene scene;
    std::unique_ptr<Accelerator> accelerator;
    std::vector<Hit> hits;
    std::vector<HitPacket> packet_hits;
    std::vector<WorkCounts> work;
};

void shoot_alone(Own& own, const BenchShots& shots, int i) {
    WorkCounts& work = own.work[static_cast<std::size_t>(i)] = {};
    const std::size_t end = std::min(shots.rays.size(), static_cast<std::size_t>(i + 1) * chunk);
    for (std::size_t k = static_cast<std::size_t>(i) * chunk; k < end; ++k) {
        if (shots.occlusion) {
            own.hits[k] = {.node = own.accelerator->occluded(shots.rays[k], work) ? 0 : no_node};
        } else {
            own.hits[k] = own.accelerator->closest(shots.rays[k], work);
        }
    }
}

void shoot_packets(Own& own, const BenchShots& shots, int i) {
    WorkCounts& work = own.work[static_cast<std::size_t>(i)] = {};
    constexpr std::size_t per_chunk = chunk / RayPacket::capacity;
    const std::size_t end = std::min(shots.packets.size(), (i + 1) * per_chunk);
    for (std::size_t k = i * per_chunk; k < end; ++k) {
        if (shots.occlusion) {
            std::array<std::uint8_t, RayPacket::capacity> blocked;
            own.accelerator->occluded(shots.packets[k], blocked, work);
            for (int r = 0; r < RayPacket::capacity; ++r) {
                own.packet_hits[k].node[r] = blocked[r] != 0 ? 0 : no_node;
            }
        } else {
            own.accelerator->closest(shots.packets[k], own.packet_hits[k], work);
        }
    }
}

std::vector<Contender> contenders_of(Own& own, const EmbreeScene* embree, const BenchShots& shots,
                                     const RayBench& bench) {
    std::vector<Contender> all;
    const bool coherent = !shots.packets.empty();
    for (const std::string& backend : bench.backends) {
        if (backend == "luch") {
            all.push_back({backend, "single", [] {}, [&](int i) { shoot_alone(own, shots, i); }});
            if (!coherent) continue;
            all.push_back({backend, "packet", [] {}, [&](int i) { shoot_packets(own, shots, i); }});
            continue;
        }
        for (std::size_t mode = 0; mode < embree_mode_names.size(); ++mode) {
            const std::shared_ptr<EmbreeScene::Batch> batch =
                embree->batch(shots.rays, static_cast<EmbreeMode>(mode), coherent);
            const std::size_t n = shots.rays.size();
            const bool occlusion = shots.occlusion;
            all.push_back({backend, std::string(embree_mode_names[mode]),
                           [batch] { batch->reset(); },
                           [batch, n, occlusion](int i) {
                               const auto first = static_cast<std::size_t>(i) * chunk;
                               batch->shoot(first, std::min(n, first + chunk), occlusion);
                           }});
        }
    }
    return all;
}

/// Every contender's turns, in every round; the first round warms up.
void race(std::vector<Contender>& contenders, const Own& own, std::size_t rays,
          const RayBench& bench) {
    const Workers workers(bench.threads);
    const int chunks = static_cast<int>((rays + chunk - 1) / chunk);
    const int turns = (chunks + chunks_in_turn - 1) / chunks_in_turn;
    for (Contender& each : contenders) each.seconds.resize(static_cast<std::size_t>(turns));
    for (int round = -1; round < bench.rounds; ++round) {
        for (Contender& each : contenders) each.reset();
        for (int turn = 0; turn < turns; ++turn) {
            const int first = turn * chunks_in_turn;
            const int count = std::min(chunks_in_turn, chunks - first);
            for (Contender& each : contenders) {
                const double seconds = seconds_of(bench.threads, [&] {
                    workers.for_each(count, [&](int i, int) { each.shoot(first + i); });
                });
                if (round >= 0) each.seconds[static_cast<std::size_t>(turn)].push_back(seconds);
            }
        }
    }
    for (Contender& each : contenders) {
        if (each.backend != "luch") continue;
        for (int i = 0; i < chunks; ++i) each.shoot(i);
        for (const WorkCounts& work : own.work) each.work += work;
    }
}

/// The sum of the turns' medians.
double seconds_of(const Contender& contender) {
    double sum = 0;
    for (const std::vector<double>& turn : contender.seconds) sum += median(turn);
    return sum;
}

/// Counts a ray that one hits and the other does not, or where they meet two triangles.
void judge(const Mesh& mesh, double scale, const Ray& ray, const Hit& ours, const Hit& theirs,
           RayKindSpeed& speed) {
    const Judgement truth = judged(mesh, scale, ray);
    if (static_cast<bool>(theirs) != static_cast<bool>(ours)) {
        ++(truth.verdict == Verdict::doubtful ? speed.hit_doubts : speed.hit_mismatches);
        return;
    }
    const auto right = [&](const Hit& hit) {
        return std::ranges::count(truth.nearest, hit.primitive) > 0;
    };
    if (!right(ours) || !right(theirs)) ++speed.prim_mismatches;
}

/// Compares luch's hits with those of Embree's robust mode.
void compare(const Own& own, const EmbreeScene& robust, const BenchShots& shots, double scale,
             RayKindSpeed& speed) {
    const auto batch = robust.batch(shots.rays, EmbreeMode::single, false);
    batch->reset();
    batch->shoot(0, shots.rays.size(), shots.occlusion);
    const Mesh& mesh = std::get<Mesh>(own.scene.geometries[0]);
    std::uint64_t both = 0, same = 0;
    for (std::size_t i = 0; i < shots.rays.size(); ++i) {
        if (!(shots.rays[i].t_max > shots.rays[i].t_min)) continue;
        const Hit theirs = batch->hit(i), &ours = own.hits[i];
        const bool agree = theirs.primitive == ours.primitive || shots.occlusion;
        if (theirs && ours) {
            ++both;
            same += agree ? 1 : 0;
        }
        if (agree && static_cast<bool>(theirs) == static_cast<bool>(ours)) continue;
        judge(mesh, scale, shots.rays[i], ours, theirs, speed);
    }
    speed.prim_agreement = both > 0 ? static_cast<double>(same) / static_cast<double>(both) : 1;
}

std::vector<RayKindSpeed> speeds_of(const std::vector<Contender>& contenders,
                                    const BenchShots& shots, const std::string& kind) {
    std::vector<RayKindSpeed> speeds;
    const auto rays = static_cast<double>(shots.active);
    for (const Contender& each : contenders) {
        if (speeds.empty() || speeds.back().backend != each.backend) {
            speeds.push_back(
                {.kind = kind, .backend = each.backend, .modes = {}, .rays = shots.active});
        }
        speeds.back().modes.push_back({each.mode, 1e-6 * rays / seconds_of(each),
                                       static_cast<double>(each.work.boxes) / rays,
                                       static_cast<double>(each.work.primitives) / rays});
    }
    return speeds;
}

/// The builds, each by one thread, in turn.
std::vector<double> raced_builds(const Own& own, const Mesh& mesh, const RayBench& bench) {
    std::vector<std::vector<double>> ms(bench.backends.size());
    for (int round = 0; round < 5; ++round) {
        for (std::size_t i = 0; i < ms.size(); ++i) {
            ms[i].push_back(1e3 * cpu_seconds_of([&] {
                                if (bench.backends[i] == "luch") {
                                    build_accelerator(own.scene, bench.isa);
                                } else {
                                    EmbreeScene(mesh, 1, false, bench.isa);
                                }
                            }));
        }
    }
    std::vector<double> medians;
    for (auto& each : ms) medians.push_back(median(each));
    return medians;
}

Own own_scene(const Mesh& mesh, const RayBench& bench) {
    Own own;
    Mesh raw = mesh;
    raw.from_frame = {};
    own.scene.geometries.emplace_back(std::move(raw));
    own.scene.materials.emplace_back(Lambert{});
    add_node(own.scene, "mesh", 0, 0, Transform::scaling(Vec3d(bench.scale)));
    own.accelerator = build_accelerator(own.scene, bench.isa);
    return own;
}

BenchShots shots_of(const std::string& kind, const Own& own, const BenchView& view, int side) {
    BenchShots primary = primary_shots(view, side);
    if (kind == "primary") return primary;
    WorkCounts work;
    std::vector<Hit> hits;
    for (const Ray& ray : primary.rays) hits.push_back(own.accelerator->closest(ray, work));
    const double offset = 1e-4 * glm::length(view.at - view.eye);
    if (kind == "shadow") return shadow_shots(own.scene, view, hits, offset);
    return diffuse_shots(own.scene, primary, hits, offset);
}

}  // namespace

const RayModeSpeed& RayKindSpeed::best() const {
    return *std::max_element(modes.begin(), modes.end(), [](const auto& a, const auto& b) {
        return a.mrays_per_s < b.mrays_per_s;
    });
}

double RayKindSpeed::speed_of(const std::string& mode) const {
    for (const RayModeSpeed& each : modes) {
        if (each.mode == mode) return each.mrays_per_s;
    }
    return 0;
}

MeshSpeed raced(const std::string& name, const Mesh& mesh, const BenchView& view,
                const RayBench& bench) {
    Own own = own_scene(mesh, bench);
    const bool peer = std::ranges::count(bench.backends, "embree") > 0;
    std::optional<EmbreeScene> fast, robust;
    if (peer) {
        fast.emplace(mesh, static_cast<float>(bench.scale), false, bench.isa);
        robust.emplace(mesh, static_cast<float>(bench.scale), true, bench.isa);
    }
    MeshSpeed result{name, mesh.triangles.size(), raced_builds(own, mesh, bench), {}};
    const BenchView scaled{view.eye * bench.scale, view.at * bench.scale, view.light * bench.scale};
    for (const std::string& kind : bench.kinds) {
        const BenchShots shots = shots_of(kind, own, scaled, bench.side);
        own.hits.assign(shots.rays.size(), {});
        own.work.assign(shots.rays.size() / chunk + 1, {});
        own.packet_hits.resize(shots.packets.size());
        auto contenders = contenders_of(own, fast ? &*fast : nullptr, shots, bench);
        race(contenders, own, shots.rays.size(), bench);
        auto speeds = speeds_of(contenders, shots, kind);
        for (int i = 0; i * chunk < static_cast<int>(shots.rays.size()); ++i) {
            shoot_alone(own, shots, i);
        }
        if (robust) compare(own, *robust, shots, bench.scale, speeds.back());
        result.kinds.insert(result.kinds.end(), speeds.begin(), speeds.end());
    }
    return result;
}

}  // namespace luch
