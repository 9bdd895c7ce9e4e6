#include "framework/parallel/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace luch {
namespace {

TEST(Workers, CoverEveryPixelOnce) {
    for (const int threads : {1, 2, 16}) {
        const Workers workers(threads);
        EXPECT_EQ(workers.count(), threads);
        for (const Size size : {Size{1, 1}, Size{33, 17}, Size{641, 7}}) {
            std::vector<std::atomic<int>> seen(size.area());
            workers.for_each_tile(size, 16, [&](Tile tile, int worker) {
                EXPECT_TRUE(worker >= 0 && worker < threads);
                for (int y = tile.y0; y < tile.y1; ++y) {
                    for (int x = tile.x0; x < tile.x1; ++x) ++seen[y * size.width + x];
                }
            });
            for (const auto& count : seen) EXPECT_EQ(count, 1);
        }
    }
}

TEST(Workers, RethrowTheFirstExceptionOnceAndStayUsable) {
    const Workers workers(4);
    for (int i = 0; i < 10; ++i) {
        EXPECT_THROW(workers.for_each(1000, [](int, int) { throw std::runtime_error("no"); }),
                     std::runtime_error);
        std::atomic<int> sum = 0;
        workers.for_each(100, [&](int k, int) { sum += k; });
        EXPECT_EQ(sum, 4950);
    }
}

TEST(Workers, RunOnAsManyThreadsAsAskedForBesideASmallerPool) {
    const Workers small(1), large(4);
    std::atomic<int> inside = 0, gave_up = 0;
    // Each call waits until all four are inside; with fewer threads the first would wait in vain.
    large.for_each(4, [&](int, int) {
        ++inside;
        for (int i = 0; i < 2000 && inside < 4; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        if (inside < 4) ++gave_up;
    });
    EXPECT_EQ(gave_up, 0);
}

TEST(Workers, BeginNothingMoreAfterACancel) {
    const Workers workers(1);
    CancelToken cancel;
    int calls = 0;
    workers.for_each(
        100,
        [&](int, int) {
            ++calls;
            cancel.cancel();
        },
        &cancel);
    EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace luch
