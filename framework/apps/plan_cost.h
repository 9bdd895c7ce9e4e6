#pragma once

#include "framework/technique/run.h"

#include <memory>
#include <vector>

namespace luch {

/// A technique's frames with what the scene needs, and with every stage forced on that is left out
/// exactly or within a bound.
struct PlanCost {
    Outcome planned, forced;
    /// Of frames made in turn, planned then forced, after one of each.
    std::vector<double> planned_ms, forced_ms;

    [[nodiscard]] bool identical() const { return planned.frame.colour == forced.frame.colour; }
    /// The median of forced over planned, pair by pair.
    [[nodiscard]] double ratio() const;
};

/// Makes `frames` of each, in turn, so that what else the machine does meets both. Processor time.
PlanCost cost_of_plan(Technique& technique, const Studio& planned, const Accelerator& forced,
                      const Shot& shot, int frames);

}  // namespace luch
