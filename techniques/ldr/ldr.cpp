#include "techniques/ldr/ldr.h"

#include "framework/technique/catalogue.h"
#include "techniques/ldr/plan.h"
#include "techniques/ldr/planes.h"
#include "techniques/ldr/render.h"
#include "techniques/ldr/stress.h"

#include <array>

namespace luch::techniques::ldr {
namespace {

constexpr std::array<std::string_view, 2> tone_words{"clamp", "reinhard"};
constexpr std::array<double, 7> level_counts{16, 64, 256, 1024, 4096, 16'384, 65'536};

class Ldr final : public Technique {
 public:
    explicit Ldr(const Steps& steps) : steps_(steps), reference_(reference()) {}

    void visit(ParamVisitor& visitor) override {
        visitor.visit({"wide", "", "Accumulators where the plan needs them; off: words only."},
                      params_.wide);
        visitor.visit({"dither", "", "Noise instead of steps, before words go to the screen."},
                      params_.dither);
        visitor.visit({"levels", "", "Levels of a channel; 256: words of 32 bits."}, params_.levels,
                      16, 65'536);
        visitor.visit({"exposure", "stops", "Light is multiplied by two to this power."},
                      params_.exposure_ev, -20, 20);
        visitor.visit({"tone", "", "What becomes of light above white."}, params_.tone, tone_words);
        visitor.visit({"textures", "", "Bitmaps in words, where not a bit is lost."},
                      params_.textures);
    }

    [[nodiscard]] Plan plan(const Scene& scene, const Shot& shot) const override {
        return plan_of(scene, shot, params_);
    }

    void prepare(const Scene& scene, const Shot&, Context& context) override {
        textures_ = runs(context.plan(), word_textures) ? luch::word_textures(scene.textures)
                                                        : WordTextures();
    }

    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        const Plan& plan = context.plan();
        make_planes(frame);
        const Job job{.scene = scene,
                      .shot = shot,
                      .frame = frame,
                      .context = context,
                      .look = {.steps = &steps_,
                               .reference = &reference_,
                               .context = &context,
                               .ambient = scene.settings.ambient_light,
                               .exposure = static_cast<float>(std::exp2(params_.exposure_ev)),
                               .gathers = runs(plan, wide_light),
                               .levels = params_.levels},
                      .textures = textures_.empty() ? nullptr : &textures_,
                      .dither = params_.dither,
                      .toned = runs(plan, tone_mapping)};
        const Misfits misfits = rendered(job, runs(plan, accumulator));
        context.did("wide light", misfits.too_bright, "channels above white");
    }

 private:
    [[nodiscard]] Misfits rendered(const Job& job, bool accumulates) const {
        if (params_.levels != 256) return Renderer<LevelCanvas>(job).render();
        if (job.look.gathers || accumulates) return Renderer<WideCanvas>(job).render();
        return Renderer<WordCanvas>(job).render();
    }

    Params params_;
    Steps steps_, reference_;
    WordTextures textures_;
};

}  // namespace

std::unique_ptr<Technique> make(const Steps& steps) {
    return std::make_unique<Ldr>(steps);
}

const std::span<const double> levels_sweep{level_counts};

TechniqueInfo describe() {
    return {.name = "ldr",
            .title = "colours in words of 32 bits",
            .topic = "2. LDR colour",
            .create = [] { return make(reference()); },
            .sweep = {"levels", levels_sweep, -1},
            .resolution = resolution,
            .stress_cases = stress_cases};
}

}  // namespace luch::techniques::ldr
