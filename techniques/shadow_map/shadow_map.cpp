#include "techniques/shadow_map/shadow_map.h"

#include "framework/baseline/classic.h"
#include "framework/technique/catalogue.h"
#include "techniques/shadow_map/judged.h"
#include "techniques/shadow_map/planes.h"
#include "techniques/shadow_map/source.h"
#include "techniques/shadow_map/stress.h"

namespace luch::techniques::shadow_map {
namespace {

constexpr std::array<double, 7> sides{32, 64, 128, 256, 512, 1024, 2048};
constexpr std::array<std::string_view, 6> mode_words{"classic", "pcss",      "vsm",
                                                     "msm",     "heuristic", "exact"};
constexpr std::array<std::string_view, 3> pattern_words{"regular", "jittered", "random"};
constexpr std::array<std::string_view, 2> layout_words{"cube", "sphere"};

class ShadowMap final : public Technique {
 public:
    ShadowMap(const Steps& steps, Mode mode) : steps_(steps), atlas_(steps) {
        params_.mode = static_cast<int>(mode);
    }

    void visit(ParamVisitor& visitor) override {
        visitor.visit({"mode", "", "What answers: a comparison, a filter, or items and rays."},
                      params_.mode, mode_words);
        visitor.visit({"side", "texels", "Along an edge of a face of a map."}, params_.side, 1,
                      4096);
        visitor.visit({"pcf", "", "The mean of 3 × 3 comparisons, or one (classic)."}, params_.pcf);
        visitor.visit({"layout", "", "A cube around the light, or a sphere (classic)."},
                      params_.layout, layout_words);
        visitor.visit({"bias", "", "Times the bias that geometry asks for."}, params_.bias, 0.0,
                      100.0);
        visitor.visit({"offset", "", "Along the normal in the bias's place, when grazing."},
                      params_.offset);
        visitor.visit({"fit", "", "Far lights look at what receives their light only."},
                      params_.fit);
        visitor.visit({"points", "", "That stand for a light with an area."}, params_.points, 1,
                      1024);
        visitor.visit({"pattern", "", "Where they lie."}, params_.pattern, pattern_words);
        visitor.visit({"memory", "MB", "Of maps; lights beyond that are left to rays."},
                      params_.memory, 0, 1 << 16);
        visitor.visit({"judge", "", "Show what is wrong, by a shadow ray for every answer."},
                      params_.judge);
        visitor.visit({"unwrap", "", "Show the first light's map, not the scene."}, params_.unwrap);
    }

    [[nodiscard]] Plan plan(const Scene& scene, const Shot& shot) const override {
        return plan_of(scene, shot, params_);
    }

    void prepare(const Scene& scene, const Shot& shot, Context& context) override {
        atlas_.update(scene, shot, params_, context);
    }

    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        // Of the maps that were made for this frame; the frames after it use them as they are.
        context.did(stage::maps, atlas_.filled(), "texels");
        context.did(stage::memory, atlas_.bytes(), "bytes");
        if (params_.unwrap) return unwrap(atlas_, frame.colour.view());
        const Needs needs = needs_of(context.plan());
        const bool filter = params_.pcf && context.plan().needed(stage::filter);
        const Steps steps = asked_steps(steps_, filter, context);
        std::vector<MapSource> sources;
        for (int worker = 0; worker < context.workers(); ++worker) {
            sources.emplace_back(steps, params_, filter, atlas_, scene, context,
                                 context.tracer(worker));
        }
        const ShadowPlanes planes(frame, context.budget().planes, params_.judge);
        std::vector<JudgedSource> judged;
        for (int worker = 0; worker < context.workers(); ++worker) {
            judged.emplace_back(sources[static_cast<std::size_t>(worker)], scene,
                                context.tracer(worker), planes);
        }
        trace_frame(scene, shot, needs, context, frame.colour.view(),
                    [&](int worker) -> KnownLightOf {
                        const auto w = static_cast<std::size_t>(worker);
                        return [&, w](const TileRays& rays) {
                            judged[w].look_at(rays);
                            return KnownLight{.shadows = &judged[w]};
                        };
                    });
    }

 private:
    Steps steps_;
    Params params_;
    Atlas atlas_;
};

}  // namespace

std::unique_ptr<Technique> make(const Steps& steps, Mode mode) {
    return std::make_unique<ShadowMap>(steps, mode);
}

const std::span<const double> side_sweep{sides};

TechniqueInfo describe() {
    return {.name = "shadow_map",
            .title = "shadow maps of distance around each light",
            .topic = "5. shadow maps",
            .create = [] { return make(reference()); },
            .sweep = {"side", side_sweep, -0.5},
            .stress_cases = stress_cases};
}

}  // namespace luch::techniques::shadow_map
