#include "framework/technique/stereo.h"

#include <algorithm>

namespace luch {
namespace {

Rgb muted(const Rgb& colour) {
    const Rgb grey((colour.r + colour.g + colour.b) / 3);
    return grey + (colour - grey) * 0.3f;
}

/// Frames are made pairwise; where one eye made more of them, the rest does not count.
std::vector<double> sums(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> sums;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) sums.push_back(a[i] + b[i]);
    return sums;
}

Plan either(Plan left, const Plan& right) {
    if (!right.applies) return right;
    for (std::size_t i = 0; i < std::min(left.stages.size(), right.stages.size()); ++i) {
        if (right.stages[i].needed && !left.stages[i].needed) left.stages[i] = right.stages[i];
    }
    return left;
}

}  // namespace

Rgb anaglyph(const Rgb& left, const Rgb& right) {
    const Rgb cyan = muted(right);
    return {muted(left).r, cyan.g, cyan.b};
}

Outcome stereo_outcome(Outcome left, const Outcome& right) {
    left.plan = either(left.plan, right.plan);
    left.prepare_ms += right.prepare_ms;
    left.frame_ms = sums(left.frame_ms, right.frame_ms);
    left.cpu_ms = sums(left.cpu_ms, right.cpu_ms);
    left.counts += right.counts;
    for (const std::string& task : right.unwritten) {
        if (std::find(left.unwritten.begin(), left.unwritten.end(), task) == left.unwritten.end()) {
            left.unwritten.push_back(task);
        }
    }
    if (!left.plan.applies) {
        left.frame = Frame(Size{});
        return left;
    }
    auto& colours = left.frame.colour.pixels();
    std::transform(colours.begin(), colours.end(), right.frame.colour.pixels().begin(),
                   colours.begin(), anaglyph);
    left.non_finite = non_finite_pixels(left.frame.colour.view());
    return left;
}

}  // namespace luch
