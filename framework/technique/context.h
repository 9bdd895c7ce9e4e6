#pragma once

#include "framework/parallel/workers.h"
#include "framework/technique/budget.h"
#include "framework/technique/plan.h"
#include "framework/technique/todo.h"
#include "framework/trace/tracer.h"

#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace luch {

/// A pixel of the frame whose rays are recorded.
struct Watch {
    int x = 0, y = 0;
    RayLog* log = nullptr;
};

/// What a technique may use while it makes a frame: plan, budget, threads, and tracers that count.
class Context {
 public:
    Context(const Accelerator& accelerator, const Workers& workers, Plan plan, const Budget& budget,
            const CancelToken* cancel = nullptr);

    [[nodiscard]] const Plan& plan() const { return plan_; }
    [[nodiscard]] const Budget& budget() const { return budget_; }
    [[nodiscard]] int workers() const { return workers_->count(); }
    [[nodiscard]] Tracer& tracer(int worker) { return tracers_[static_cast<std::size_t>(worker)]; }
    [[nodiscard]] bool cancelled() const { return cancel_ != nullptr && cancel_->cancelled(); }

    /// Tiles of 16 × 16 pixels unless told otherwise.
    static constexpr int tile_side = 16;
    void for_each_tile(Size size, const std::function<void(Tile, int worker)>& work,
                       int side = tile_side);
    void for_each(int n, const std::function<void(int i, int worker)>& work) const;

    /// From now on, the tile of a frame of this size that holds the pixel is cut so that the pixel
    /// is a tile of its own, and what is shot there is recorded. Any tiling gives the same bits, so
    /// the picture is the same.
    void watch(const Watch& watch, Size frame) {
        watch_ = watch;
        watched_frame_ = frame;
    }

    /// The counts of all tracers since the last call.
    Counts take_counts();

    /// Counts work of one of the technique's own stages in this frame: `n` more "triangles",
    /// "pixels"… Whole frames' sums: it locks.
    void did(std::string_view stage, std::uint64_t n, std::string_view counted);
    /// Tells the plan's stages what was counted of them, and begins anew.
    void take_work(Plan& plan);

    /// The threads themselves, for parts of the framework that share out their work.
    [[nodiscard]] const Workers& pool() const { return *workers_; }

    /// A homework's task was not written; render goes on with the reference. Called by call_step().
    void not_written(const std::string& task);
    [[nodiscard]] const std::set<std::string>& unwritten() const { return unwritten_; }

    /// The viewer steps through a technique with this; elsewhere it does nothing.
    void pause(std::string_view stage) const {
        if (on_pause) on_pause(stage);
    }
    std::function<void(std::string_view)> on_pause;

 private:
    const Workers* workers_;
    Plan plan_;
    Budget budget_;
    const CancelToken* cancel_;
    void watched_tile(Tile tile, int worker, const std::function<void(Tile, int)>& work);

    std::vector<Tracer> tracers_;
    std::optional<Watch> watch_;
    Size watched_frame_;
    std::mutex mutex_;
    std::set<std::string> unwritten_;
    std::vector<Stage> work_;
};

/// False where work that calls a step meets a hole; the task is recorded. Where a step is called
/// for many single points, one call with nothing to do tells beforehand: a hole that is met takes
/// longer than the step.
template <class Work>
bool written(Context& context, const Work& work) {
    try {
        work();
        return true;
    } catch (const NotWritten& hole) {
        context.not_written(hole.task());
        return false;
    }
}

/// Calls a step of a technique's table. Where a homework left a hole, the task is recorded and the
/// whole call is made again with the reference. Nothing but this and written() catches NotWritten.
template <class Step, class... Arguments>
decltype(auto) call_step(Context& context, Step* step, Step* reference, Arguments&&... arguments) {
    try {
        return step(arguments...);
    } catch (const NotWritten& hole) {
        context.not_written(hole.task());
        return reference(arguments...);
    }
}

}  // namespace luch
