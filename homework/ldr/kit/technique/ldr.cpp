// The students' kit: what calls the steps. A picture for which one of them is not written is
// hatched.
#include "techniques/ldr/ldr.h"

#include "techniques/ldr/plan.h"
#include "techniques/ldr/planes.h"
#include "techniques/ldr/render.h"

#include <array>
#include <cmath>

namespace luch::techniques::ldr {
namespace {

constexpr std::array<std::string_view, 2> tone_words{"clamp", "reinhard"};
constexpr std::array<double, 7> level_counts{16, 64, 256, 1024, 4096, 16'384, 65'536};

/// Stripes over a picture that is not what it will be.
void hatch(ImageView<Rgb> colour) {
    constexpr int stripe = 4;
    for (int y = 0; y < colour.height(); ++y) {
        for (int x = 0; x < colour.width(); ++x) {
            if ((x + y) / stripe % 2 != 0) colour(x, y) *= 0.4f;
        }
    }
}

class Ldr final : public Technique {
 public:
    explicit Ldr(const Steps& steps) : steps_(steps), stand_ins_(reference()) {}

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
        make_planes(frame);
        const Job job{.scene = scene,
                      .shot = shot,
                      .frame = frame,
                      .context = context,
                      .look = {.steps = &steps_,
                               .reference = &stand_ins_,
                               .context = &context,
                               .ambient = scene.settings.ambient_light,
                               .exposure = static_cast<float>(std::exp2(params_.exposure_ev)),
                               .gathers = runs(context.plan(), wide_light),
                               .levels = params_.levels},
                      .textures = textures_.empty() ? nullptr : &textures_,
                      .dither = params_.dither,
                      .toned = runs(context.plan(), tone_mapping)};
        if (params_.levels != 256) {
            Renderer<LevelCanvas>(job).render();
        } else if (job.look.gathers || runs(context.plan(), accumulator)) {
            Renderer<WideCanvas>(job).render();
        } else {
            Renderer<WordCanvas>(job).render();
        }
        if (!context.unwritten().empty()) hatch(frame.colour.view());
    }

 private:
    Params params_;
    Steps steps_, stand_ins_;
    WordTextures textures_;
};

}  // namespace

std::unique_ptr<Technique> make(const Steps& steps) {
    return std::make_unique<Ldr>(steps);
}

const std::span<const double> levels_sweep{level_counts};

}  // namespace luch::techniques::ldr
