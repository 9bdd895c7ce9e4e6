#include "framework/technique/context.h"

#include <algorithm>
#include <array>

namespace luch {

Context::Context(const Accelerator& accelerator, const Workers& workers, Plan plan,
                 const Budget& budget, const CancelToken* cancel)
    : workers_(&workers),
      plan_(std::move(plan)),
      budget_(budget),
      cancel_(cancel),
      tracers_(static_cast<std::size_t>(workers.count()), Tracer(accelerator)) {}

void Context::for_each_tile(Size size, const std::function<void(Tile, int)>& work, int side) {
    if (!watch_ || size != watched_frame_) {
        return workers_->for_each_tile(size, side, work, cancel_);
    }
    const auto watched = [&](Tile tile, int worker) { watched_tile(tile, worker, work); };
    workers_->for_each_tile(size, side, watched, cancel_);
}

void Context::watched_tile(Tile tile, int worker, const std::function<void(Tile, int)>& work) {
    const int x = watch_->x, y = watch_->y;
    if (x < tile.x0 || x >= tile.x1 || y < tile.y0 || y >= tile.y1) return work(tile, worker);
    const std::array<Tile, 4> around{Tile{tile.x0, tile.y0, tile.x1, y},
                                     {tile.x0, y, x, y + 1},
                                     {x + 1, y, tile.x1, y + 1},
                                     {tile.x0, y + 1, tile.x1, tile.y1}};
    for (const Tile& part : around) {
        if (part.area() > 0) work(part, worker);
    }
    tracer(worker).record(watch_->log);
    work({x, y, x + 1, y + 1}, worker);
    tracer(worker).record(nullptr);
}

void Context::for_each(int n, const std::function<void(int, int)>& work) const {
    workers_->for_each(n, work, cancel_);
}

Counts Context::take_counts() {
    Counts sum;
    for (Tracer& tracer : tracers_) {
        sum += tracer.counts();
        tracer.counts() = {};
    }
    return sum;
}

void Context::did(std::string_view stage, std::uint64_t n, std::string_view counted) {
    const std::lock_guard lock(mutex_);
    auto found = std::ranges::find(work_, stage, &Stage::name);
    if (found == work_.end()) {
        found = work_.emplace(work_.end());
        found->name = stage;
    }
    found->work += n;
    found->worked_on = counted;
}

void Context::take_work(Plan& plan) {
    for (const Stage& done : work_) {
        const auto stage = std::ranges::find(plan.stages, done.name, &Stage::name);
        if (stage == plan.stages.end()) continue;
        stage->work = done.work;
        stage->worked_on = done.worked_on;
    }
    work_.clear();
}

void Context::not_written(const std::string& task) {
    const std::lock_guard lock(mutex_);
    unwritten_.insert(task);
}

}  // namespace luch
