#pragma once

#include "framework/technique/run.h"
#include "framework/window/pixel.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace luch {

struct NamedTechnique {
    std::string name;
    Technique* technique;
};

/// A picture to be made, by one technique or by several in turn. The techniques must outlive the
/// renderer; only its thread uses them while it is busy.
struct RenderRequest {
    std::vector<NamedTechnique> techniques;
    Technique* fallback = nullptr;  ///< renders in place of one whose plan does not apply
    Shot shot;
    Budget budget;
    Repeat repeat{0, 1};
    int divisor = 1;      ///< for whoever asked: how coarse it is
    bool timing = false;  ///< for whoever asked: made to see how long it takes
};

/// What one of the techniques made.
struct Rendered {
    Outcome outcome;       ///< the fallback's, when it took over
    std::string declined;  ///< why the technique itself does not apply; "" when it does
    Image<Pixel> picture;  ///< the frame as a screen shows it
};

struct RenderResult {
    RenderRequest request;
    std::vector<Rendered> rendered;  ///< in the order of the request
};

/// Renders on a thread of its own, one request at a time; a newer request cancels the one before.
class Renderer {
 public:
    /// Scene, accelerator and workers must outlive it.
    explicit Renderer(const Studio& studio);
    /// Cancels, and waits for the technique to notice.
    ~Renderer();

    /// Gives up what is running or waiting, then renders this.
    void start(RenderRequest request);
    /// Gives up what is running or waiting; nothing of it will be seen.
    void cancel();
    [[nodiscard]] bool busy() const;
    /// The result of the latest request, once, when it is there. What the technique threw is thrown
    /// here, once; the renderer stays usable.
    std::optional<RenderResult> take();
    /// Waits until nothing runs; false when that took longer than `limit`.
    bool wait(std::chrono::milliseconds limit) const;

 private:
    struct Job {
        RenderRequest request;
        std::shared_ptr<CancelToken> cancelled;
    };
    void loop();
    void finish(const Job& job, std::optional<RenderResult> result, std::exception_ptr failure);
    void give_up();  // call it with the mutex locked

    Studio studio_;
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::optional<Job> waiting_;
    std::shared_ptr<CancelToken> running_;  // of the job on the thread; null when idle
    std::optional<RenderResult> result_;
    std::exception_ptr failure_;
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace luch
