#include "framework/measure/measurement.h"

#include "framework/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

namespace luch {
namespace {

/// A frame or a preparation so long that one round must do.
constexpr double slow_ms = 2'000;

constexpr int most_rounds = 3;

Outcome outcome_of(const Subject& subject, const Workbench& bench, std::uint64_t seed,
                   Repeat repeat) {
    const std::unique_ptr<Technique> technique = subject.info->create();
    if (!subject.assignment.empty()) set_param(*technique, subject.assignment);
    Shot shot = bench.shot;
    shot.spp = subject.spp;
    shot.seed = seed;
    Budget budget = bench.budget;
    budget.skip = subject.skip;
    budget.planes = false;
    return run(*technique, bench.studio, shot, budget, repeat);
}

/// The frames of a later round go to those of the earlier ones; all else is the same in each.
void append(Measurement& all, const Outcome& round) {
    all.outcome.prepare_ms = std::min(all.outcome.prepare_ms, round.prepare_ms);
    const auto add = [](std::vector<double>& to, const std::vector<double>& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    add(all.outcome.frame_ms, round.frame_ms);
    add(all.outcome.cpu_ms, round.cpu_ms);
}

void run_rounds(Measurement& all, const Subject& subject, const Subject* beside,
                const Workbench& bench, Repeat repeat) {
    const int rounds = std::clamp(repeat.frames, 1, most_rounds);
    const Repeat each{repeat.warm_up, (repeat.frames + rounds - 1) / rounds};
    for (int i = 0; i < rounds; ++i) {
        Outcome round = outcome_of(subject, bench, bench.shot.seed, each);
        if (!round.plan.applies) {
            all.outcome.plan = round.plan;
            all.not_run = "does not apply: " + round.plan.why;
            return;
        }
        const double spent_ms = round.prepare_ms + median(round.frame_ms);
        if (i == 0) {
            all.outcome = std::move(round);
        } else {
            append(all, round);
        }
        if (beside != nullptr) {
            const Outcome other = outcome_of(*beside, bench, bench.shot.seed, each);
            all.beside_ms.insert(all.beside_ms.end(), other.frame_ms.begin(), other.frame_ms.end());
        }
        if (spent_ms > slow_ms) return;
    }
}

}  // namespace

double Measurement::beside() const {
    return median(beside_ms.empty() ? outcome.frame_ms : beside_ms);
}

Image<Rgb> picture_of(const Subject& subject, const Workbench& bench, std::uint64_t seed) {
    Outcome outcome = outcome_of(subject, bench, seed, {0, 1});
    if (outcome.plan.applies) return std::move(outcome.frame.colour);
    throw Error(fmt::format("{} does not apply: {}", subject.info->name, outcome.plan.why));
}

Measurement measured(const Subject& subject, const Subject* beside, const Workbench& bench,
                     Repeat repeat) {
    Measurement all;
    try {
        run_rounds(all, subject, beside, bench, repeat);
    } catch (const std::exception& error) {
        all = {};
        all.not_run = fmt::format("failed: {}", error.what());
    }
    return all;
}

}  // namespace luch
