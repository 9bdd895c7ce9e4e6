#include "framework/technique/context.h"

namespace luch {

Context::Context(const Accelerator& accelerator, const Workers& workers, Plan plan,
                 const Budget& budget, const CancelToken* cancel)
    : workers_(&workers),
      plan_(std::move(plan)),
      budget_(budget),
      cancel_(cancel),
      tracers_(static_cast<std::size_t>(workers.count()), Tracer(accelerator)) {}

void Context::for_each_tile(Size size, const std::function<void(Tile, int)>& work, int side) const {
    workers_->for_each_tile(size, side, work, cancel_);
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

void Context::not_written(const std::string& task) {
    const std::lock_guard lock(mutex_);
    unwritten_.insert(task);
}

}  // namespace luch
