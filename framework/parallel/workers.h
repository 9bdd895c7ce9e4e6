#pragma once

#include "framework/math/size.h"

#include <atomic>
#include <functional>
#include <memory>

namespace luch {

/// Set from any thread; long work looks at it between tiles and ends early.
class CancelToken {
 public:
    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    [[nodiscard]] bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

 private:
    std::atomic<bool> cancelled_{false};
};

/// A fixed number of threads that share work out by tiles (oneTBB, named only in workers.cpp).
class Workers {
 public:
    static constexpr int most_threads = 1024;
    /// 0 means one for every core that this process may use; no more than most_threads.
    explicit Workers(int threads = 0);
    ~Workers();
    Workers(Workers&&) noexcept;

    [[nodiscard]] int count() const { return count_; }

    /// Calls work(tile, worker) for every tile of a frame, worker in [0, count()). Tiles are side ×
    /// side pixels, smaller at the right and bottom edges. The first exception stops the tiles not
    /// yet begun and is rethrown here, once; the pool stays usable. After `cancel`, tiles not yet
    /// begun are skipped.
    void for_each_tile(Size size, int side, const std::function<void(Tile, int worker)>& work,
                       const CancelToken* cancel = nullptr) const;

    /// Calls work(i, worker) for 0 ≤ i < n, under the same rules.
    void for_each(int n, const std::function<void(int i, int worker)>& work,
                  const CancelToken* cancel = nullptr) const;

 private:
    struct Arena;
    std::unique_ptr<Arena> arena_;
    int count_ = 1;
};

/// Runs both, at once where a thread is free, and returns when both are done. For work that divides
/// itself; runs in the pool of the caller, if it is called from one.
void run_both(const std::function<void()>& one, const std::function<void()>& other);

}  // namespace luch
