#pragma once

#include "framework/accel/accelerator.h"
#include "framework/parallel/workers.h"
#include "framework/technique/budget.h"
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
Outcome run(Technique& technique, const Studio& studio, const Shot& shot, const Budget& budget = {},
            Repeat repeat = {}, const CancelToken* cancel = nullptr);

}  // namespace luch
