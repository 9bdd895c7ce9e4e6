#include "framework/parallel/workers.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>

namespace luch {

struct Workers::Arena {
    explicit Arena(int threads) : arena(threads) {
        // The library's limit is the smallest that anyone living asks for, and without one it is
        // the number of cores. Set once for good, so that pools neither hold one another down nor
        // stay below the number of threads asked for.
        static const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                               most_threads);
    }
    tbb::task_arena arena;
};

Workers::Workers(int threads) : count_(threads > 0 ? threads : tbb::info::default_concurrency()) {
    arena_ = std::make_unique<Arena>(count_);
}
Workers::~Workers() = default;
Workers::Workers(Workers&&) noexcept = default;

void Workers::for_each(int n, const std::function<void(int, int)>& work,
                       const CancelToken* cancel) const {
    arena_->arena.execute([&] {
        tbb::parallel_for(
            0, n,
            [&](int i) {
                if (cancel != nullptr && cancel->cancelled()) return;
                work(i, tbb::this_task_arena::current_thread_index());
            },
            tbb::simple_partitioner{});
    });
}

void Workers::for_each_tile(Size size, int side, const std::function<void(Tile, int)>& work,
                            const CancelToken* cancel) const {
    const int across = (size.width + side - 1) / side;
    const int down = (size.height + side - 1) / side;
    for_each(
        across * down,
        [&](int i, int worker) {
            const int x = i % across * side, y = i / across * side;
            work({x, y, std::min(x + side, size.width), std::min(y + side, size.height)}, worker);
        },
        cancel);
}

void run_both(const std::function<void()>& one, const std::function<void()>& other) {
    tbb::parallel_invoke(one, other);
}

}  // namespace luch
