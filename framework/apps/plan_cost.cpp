#include "framework/apps/plan_cost.h"

namespace luch {

double PlanCost::ratio() const {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < planned_ms.size(); ++i) {
        ratios.push_back(forced_ms[i] / planned_ms[i]);
    }
    return median(ratios);
}

namespace {

/// Those that are left out without a guess.
std::vector<std::string> left_out(const Plan& plan) {
    std::vector<std::string> names;
    for (const Stage& stage : plan.stages) {
        if (!stage.needed && stage.kind != Stage::heuristic) names.push_back(stage.name);
    }
    return names;
}

}  // namespace

PlanCost cost_of_plan(Technique& technique, const Studio& planned, const Accelerator& forced,
                      const Shot& shot, int frames) {
    constexpr Repeat once{.warm_up = 0, .frames = 1};
    const Studio all{planned.scene, forced, planned.workers};
    const Budget as_planned{.planes = false};
    const Budget everything{.planes = false,
                            .forced = left_out(technique.plan(planned.scene, shot))};
    PlanCost cost;
    for (int i = -1; i < frames; ++i) {
        cost.planned = run(technique, planned, shot, as_planned, once);
        cost.forced = run(technique, all, shot, everything, once);
        if (i < 0 || !cost.planned.plan.applies) continue;
        cost.planned_ms.push_back(median(cost.planned.cpu_ms));
        cost.forced_ms.push_back(median(cost.forced.cpu_ms));
    }
    return cost;
}

}  // namespace luch
