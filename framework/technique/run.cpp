#include "framework/technique/run.h"

#include "framework/technique/stereo.h"
#include "framework/trace/focus.h"

#include <chrono>
#include <ctime>

namespace luch {
namespace {

/// Wall and processor time since it was made.
class Stopwatch {
 public:
    [[nodiscard]] double wall_ms() const {
        const auto passed = std::chrono::steady_clock::now() - wall_;
        return std::chrono::duration<double, std::milli>(passed).count();
    }
    [[nodiscard]] double cpu_ms() const { return process_ms() - cpu_; }

 private:
    static double process_ms() {
        timespec now{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
        return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
    }
    std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
    double cpu_ = process_ms();
};

/// A frame so long that one of them must do.
constexpr double endless_ms = 30'000;

/// How many frames in all, once the time of one is known.
int frames_worth(int asked, double first_ms) {
    if (first_ms > endless_ms) return 1;
    return first_ms > 2'000 ? std::min(asked, 3) : asked;
}

/// Tells the plan's stages how often they were at work.
void count_work(Plan& plan, const Counts& counts) {
    for (std::size_t i = 0; i < part_names.size(); ++i) {
        for (Stage& stage : plan.stages) {
            if (stage.name != part_names[i].name) continue;
            stage.work = counts.of(static_cast<Part>(i));
            stage.worked_on = part_names[i].counted;
        }
    }
}

/// With one eye.
Outcome run_once(Technique& technique, const Studio& studio, const Shot& shot, const Budget& budget,
                 Repeat repeat, const CancelToken* cancel, const std::optional<Watch>& watch) {
    Outcome outcome;
    outcome.plan = technique.plan(studio.scene, shot);
    if (!budget.skip) outcome.plan.need_all();
    for (const std::string& stage : budget.forced) outcome.plan.need(stage);
    outcome.threads = studio.workers.count();
    if (!outcome.plan.applies) return outcome;

    Context context(studio.accelerator, studio.workers, outcome.plan, budget, cancel);
    if (watch) context.watch(*watch, shot.size);
    outcome.frame = Frame(shot.size);
    const Stopwatch preparing;
    technique.prepare(studio.scene, shot, context);
    outcome.prepare_ms = preparing.wall_ms();
    context.take_counts();

    // A warm-up frame is timed like any other, to know how many are worth making; one that is too
    // long to be made again counts.
    int wanted = repeat.frames;
    for (int made = -repeat.warm_up; made < wanted && !context.cancelled(); ++made) {
        const Stopwatch frame;
        technique.render(studio.scene, shot, outcome.frame, context);
        const double wall = frame.wall_ms(), cpu = frame.cpu_ms();
        outcome.counts = context.take_counts();
        context.take_work(outcome.plan);
        wanted = frames_worth(wanted, wall);
        if (made < 0 && wall <= endless_ms) continue;
        if (made < 0) made = 0;
        outcome.frame_ms.push_back(wall);
        outcome.cpu_ms.push_back(cpu);
    }
    count_work(outcome.plan, outcome.counts);
    outcome.non_finite = non_finite_pixels(outcome.frame.colour.view());
    outcome.unwritten.assign(context.unwritten().begin(), context.unwritten().end());
    outcome.bytes = studio.accelerator.bytes();
    return outcome;
}

}  // namespace

Outcome run(Technique& technique, const Studio& studio, const Shot& shot, const Budget& budget,
            Repeat repeat, const CancelToken* cancel, const std::optional<Watch>& watch) {
    Tracer autofocus(studio.accelerator);
    Shot focused_shot = shot;
    focused_shot.camera = focused(shot.camera, autofocus);
    const auto seen_by = [&](const Camera& camera) {
        Shot eye = focused_shot;
        eye.camera = camera;
        return run_once(technique, studio, eye, budget, repeat, cancel, watch);
    };
    const Camera& camera = focused_shot.camera;
    const bool stereo = camera.stereo_separation != 0;
    Outcome outcome = seen_by(stereo ? camera.left_eye() : camera);
    if (stereo) outcome = stereo_outcome(std::move(outcome), seen_by(camera.right_eye()));
    outcome.counts += autofocus.counts();
    return outcome;
}

}  // namespace luch
