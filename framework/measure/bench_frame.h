#pragma once

#include "framework/technique/catalogue.h"
#include "framework/technique/run.h"

#include <string>
#include <vector>

namespace luch {

/// What `luch bench frame` is asked for.
struct FrameBench {
    std::vector<Backend> backends{Backend::luch};
    std::vector<int> threads{1, 0};  ///< 0: one a core
    int rounds = 7;                  ///< how often each combination runs, in turn with the others
    Isa isa = Isa::plain;
};

/// What a whole frame costs with one back end on so many threads; medians.
struct FrameSpeed {
    Backend backend;
    int threads;
    double cpu_ms = 0;  ///< of all threads together
    double wall_ms = 0;
    Counts counts;                       ///< of one frame
    std::uint64_t different_pixels = 0;  ///< from the picture of the first combination
};

/// Races the back ends and numbers of threads over whole frames of one technique. Building and
/// preparing is not timed. Throws Error when the technique does not apply to the scene.
std::vector<FrameSpeed> raced(const Scene& scene, const Shot& shot, const TechniqueInfo& technique,
                              const FrameBench& bench);

}  // namespace luch
