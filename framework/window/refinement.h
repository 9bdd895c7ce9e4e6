#pragma once

#include <optional>

namespace luch {

/// Decides at what resolution to render next. A slow picture is made coarse first, and again
/// whenever it changes, so that flying stays smooth; once it is still, each next picture is twice
/// as fine, until it is whole. A divisor of 4 means a quarter of the width and of the height.
class Refinement {
 public:
    static constexpr double smooth_ms = 50;     ///< a moving picture may take this long
    static constexpr double patience_ms = 300;  ///< see next()
    static constexpr int coarsest = 8;
    static constexpr int first_guess = 4;  ///< while it is not known how long a picture takes

    /// Without previews every picture is whole.
    explicit Refinement(bool previews) : previews_(previews) {}

    /// The picture is to be another one, of the same kind: the camera moved.
    void changed() { stale_ = true; }
    /// A picture of another kind (technique, size): times so far say nothing about it, and what is
    /// being rendered is of no use.
    void restart();

    /// The divisor to render at now, giving up what is running; nothing: leave things as they are.
    /// A coarse picture that is out of date is let finish for patience_ms, or a flight would never
    /// show one. `running_ms`: how long it has been running.
    [[nodiscard]] std::optional<int> next(bool moving, double running_ms) const;

    void started(int divisor);
    /// What was started is there; the times are those of prepare and render.
    void finished(double prepare_ms, double render_ms);
    /// What was started failed: it is not tried again until something changes.
    void failed();

    /// Whether the whole picture is there, and nothing is left to do.
    [[nodiscard]] bool settled() const { return !stale_ && !running_ && shown_ == 1; }

 private:
    /// The divisor for a moving picture.
    [[nodiscard]] int coarse() const;

    bool previews_;
    bool stale_ = true;
    bool useless_ = false;  ///< what is running
    std::optional<int> running_;
    int shown_ = 0;  ///< divisor of the latest picture; 0: none
    std::optional<double> prepare_ms_, whole_ms_;
};

}  // namespace luch
