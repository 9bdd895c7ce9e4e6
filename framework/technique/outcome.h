#pragma once

#include "framework/technique/frame.h"
#include "framework/technique/plan.h"
#include "framework/trace/counts.h"

#include <optional>
#include <string>
#include <vector>

namespace luch {

/// Pixels that hold a NaN or an infinity: counted, never hidden.
struct NonFinite {
    std::uint64_t count = 0;
    int first_x = -1, first_y = -1;
};

/// Counts them in reading order.
NonFinite non_finite_pixels(ImageView<const Rgb> image);

/// What a run produced and what it cost.
struct Outcome {
    Plan plan;
    double prepare_ms = 0;
    std::vector<double> frame_ms;
    std::vector<double> cpu_ms;  ///< processor time of the same frames, all threads together
    int threads = 1;
    Counts counts;            ///< of one frame
    std::uint64_t bytes = 0;  ///< held by the accelerator
    NonFinite non_finite;
    std::vector<std::string> unwritten;  ///< tasks of a homework that fell back to the reference
    Frame frame{Size{}};
};

/// The middle value; 0 when there is none.
double median(std::vector<double> values);

}  // namespace luch
