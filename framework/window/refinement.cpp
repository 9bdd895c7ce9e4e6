#include "framework/window/refinement.h"

namespace luch {

void Refinement::restart() {
    stale_ = true;
    useless_ = true;
    prepare_ms_.reset();
    whole_ms_.reset();
}

std::optional<int> Refinement::next(bool moving, double running_ms) const {
    if (stale_) {
        const bool worth_waiting = running_ && !useless_ && *running_ >= coarse();
        if (worth_waiting && running_ms < patience_ms) return std::nullopt;
        return coarse();
    }
    if (running_ || moving || shown_ <= 1) return std::nullopt;
    return shown_ / 2;
}

void Refinement::started(int divisor) {
    running_ = divisor;
    stale_ = false;
    useless_ = false;
}

void Refinement::finished(double prepare_ms, double render_ms) {
    if (!running_) return;
    prepare_ms_ = prepare_ms;
    whole_ms_ = render_ms * *running_ * *running_;
    shown_ = *running_;
    running_.reset();
}

void Refinement::failed() {
    running_.reset();
    shown_ = 1;
}

int Refinement::coarse() const {
    if (!previews_) return 1;
    if (!whole_ms_) return first_guess;
    const auto expected_ms = [&](int by) { return *prepare_ms_ + *whole_ms_ / (by * by); };
    int divisor = 1;
    while (divisor < coarsest && expected_ms(divisor) > smooth_ms) divisor *= 2;
    return divisor;
}

}  // namespace luch
