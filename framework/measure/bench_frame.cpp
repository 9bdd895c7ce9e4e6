#include "framework/measure/bench_frame.h"

#include "framework/base/error.h"

namespace luch {
namespace {

/// A back end on so many threads, with what it took and made.
struct Contender {
    Backend backend;
    const Accelerator& accelerator;
    Workers workers;
    std::unique_ptr<Technique> technique;  ///< its own: it may keep things from frame to frame
    std::vector<double> cpu_ms{}, wall_ms{};
    Counts counts{};
    Image<Rgb> picture{};
};

void run_once(Contender& contender, const Scene& scene, const Shot& shot, bool counts) {
    const Studio studio{scene, contender.accelerator, contender.workers};
    Outcome outcome = run(*contender.technique, studio, shot, {}, {.warm_up = 0, .frames = 1});
    if (!outcome.plan.applies) throw Error("bench frame: " + outcome.plan.why);
    if (!counts) return;
    contender.cpu_ms.push_back(outcome.cpu_ms.at(0));
    contender.wall_ms.push_back(outcome.frame_ms.at(0));
    contender.counts = outcome.counts;
    contender.picture = std::move(outcome.frame.colour);
}

std::uint64_t differences(const Image<Rgb>& a, const Image<Rgb>& b) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        count += a.pixels()[i] == b.pixels()[i] ? 0 : 1;
    }
    return count;
}

}  // namespace

std::vector<FrameSpeed> raced(const Scene& scene, const Shot& shot, const TechniqueInfo& technique,
                              const FrameBench& bench) {
    std::vector<std::unique_ptr<Accelerator>> accelerators;
    std::vector<Contender> contenders;
    for (const Backend backend : bench.backends) {
        accelerators.push_back(build_accelerator(scene, bench.isa, backend));
        for (const int threads : bench.threads) {
            contenders.push_back(
                {backend, *accelerators.back(), Workers(threads), technique.create()});
        }
    }
    for (int round = -1; round < bench.rounds; ++round) {  // the first one warms up
        for (Contender& each : contenders) run_once(each, scene, shot, round >= 0);
    }
    std::vector<FrameSpeed> speeds;
    for (const Contender& each : contenders) {
        speeds.push_back({each.backend, each.workers.count(), median(each.cpu_ms),
                          median(each.wall_ms), each.counts,
                          differences(each.picture, contenders[0].picture)});
    }
    return speeds;
}

}  // namespace luch
