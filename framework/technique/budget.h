#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace luch {

/// What a run may spend. Counted in rays, which do not depend on the machine.
struct Budget {
    double rays_per_pixel = std::numeric_limits<double>::infinity();
    /// The viewer's only: a technique may end a frame early when it has passed.
    std::optional<double> deadline_ms = std::nullopt;
    /// False: every stage of the plan is run, needed or not.
    bool skip = true;
    /// False: nobody looks at a frame's planes; a technique need not draw them.
    bool planes = true;
    /// These are run, needed or not.
    std::vector<std::string> forced{};
    /// Told how much of a frame is done, 0..1, by techniques that may take long; from one thread.
    std::function<void(double)> on_part = nullptr;
};

}  // namespace luch
