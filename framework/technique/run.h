#pragma once

#include "framework/accel/accelerator.h"
#include "framework/parallel/workers.h"
#include "framework/technique/budget.h"
#include "framework/technique/context.h"
#include "framework/technique/outcome.h"
#include "framework/technique/technique.h"

namespace luch {

/// A scene that is ready to be rendered: loaded, accelerated, with threads to do it.
struct Studio {
    const Scene& scene;
    const Accelerator& accelerator;
    const Workers& workers;
};

/// How often a frame is made. The viewer: {0, 1}. After a first frame of over 2 s at most 3 are
/// made, over 30 s one.
struct Repeat {
    int warm_up = 1;
    int frames = 7;
};

/// Plans, prepares and renders. The only place that takes time. When the plan does not apply,
/// nothing is rendered: Outcome::plan says why and the frame is empty.
///
/// A camera with autoFocus is focused first (a ray more in the counts). One with a stereo
/// separation is two: the technique makes a whole run for each eye, left then right, and the
/// picture is an anaglyph. `watch`: records the rays of one pixel, of all frames made.
Outcome run(Technique& technique, const Studio& studio, const Shot& shot, const Budget& budget = {},
            Repeat repeat = {}, const CancelToken* cancel = nullptr,
            const std::optional<Watch>& watch = std::nullopt);

}  // namespace luch
