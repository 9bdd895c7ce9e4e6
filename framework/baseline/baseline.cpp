#include "framework/baseline/classic.h"
#include "framework/technique/catalogue.h"

namespace luch::baseline {
namespace {

/// The classic ray tracer: what every technique is compared with.
class Baseline final : public Technique {
 public:
    Plan plan(const Scene& scene, const Shot& shot) const override {
        return {.applies = true, .why = "", .stages = classic_stages(scene, shot)};
    }

    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        trace_frame(scene, shot, needs_of(context.plan()), context, frame.colour.view());
    }
};

/// Samples that are spread evenly over a pixel with edges in it: the variance falls with N^−3/2,
/// not with 1/N (Mitchell, "Consequences of Stratified Sampling in Graphics", 1996).
constexpr double spread_slope = -0.75;

}  // namespace

TechniqueInfo describe() {
    return {.name = "baseline",
            .title = "the classic ray tracer",
            .topic = "1. classic ray tracing",
            .create = []() -> std::unique_ptr<Technique> { return std::make_unique<Baseline>(); },
            .sweep = {samples_parameter, samples_sweep, spread_slope}};
}

}  // namespace luch::baseline
