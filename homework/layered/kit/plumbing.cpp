// The students' kit: what calls the steps, in the place of techniques/layered, which holds
// solutions. It has the modes that are made of the steps. Where a step is not written there is no
// reference: stand_ins.h says what is known instead, and a picture that takes more than that is
// hatched.
#include "framework/baseline/classic.h"
#include "homework/layered/stand_ins.h"
#include "techniques/layered/composite.h"

#include <algorithm>

namespace luch::techniques::layered {
namespace {

constexpr std::array<std::string_view, 2> mode_words{"discs", "classic"};
constexpr std::array<double, 7> layer_counts{2, 4, 8, 16, 32, 64, 128};
constexpr int layers_of_discs = 8;

/// Stripes over a picture that is not what it will be.
void hatch(ImageView<Rgb> colour) {
    constexpr int stripe = 4;
    for (int y = 0; y < colour.height(); ++y) {
        for (int x = 0; x < colour.width(); ++x) {
            if ((x + y) / stripe % 2 != 0) colour(x, y) *= 0.4f;
        }
    }
}

class Layered final : public Technique {
 public:
    explicit Layered(const Steps& steps) : composite_(steps) {}

    void visit(ParamVisitor& visitor) override {
        visitor.visit({"mode", "", "Blurred discs, or two layers."}, mode_, mode_words);
        visitor.visit({"layers", "", "How many, by depth; 0: 8 (discs)."}, layers_, 0, most_layers);
    }

    [[nodiscard]] Plan plan(const Scene& scene, const Shot& shot) const override {
        if (shot.camera.projection != Projection::perspective || !shot.camera.has_lens()) {
            return {false, "the camera has no thin lens (dof on, in a perspective one)", {}};
        }
        Plan plan{true, "sharp layers are blurred, no rays are shot from the lens",
                  classic_stages(scene, shot)};
        std::erase_if(plan.stages, [](const Stage& each) { return each.name == "lens"; });
        return plan;
    }

    void prepare(const Scene& scene, const Shot&, Context&) override { fragments_.prepare(scene); }

    void render(const Scene&, const Shot& shot, Frame& frame, Context& context) override {
        const Needs needs = needs_of(context.plan()).without(Part::lens);
        const Lens lens = lens_of(shot.camera, shot.size);
        const bool classic = mode_words[static_cast<std::size_t>(mode_)] == "classic";
        fragments_.see_front(shot, needs, context);
        Image<float> depths = fragments_.depth();
        if (classic) {
            // What is nearer than the plane of focus is foreground anyway.
            const auto focus = static_cast<float>(lens.focal_distance);
            for (float& depth : depths.pixels()) depth = std::max(depth, focus);
        }
        const int layers = classic ? 2 : layers_ > 0 ? layers_ : layers_of_discs;
        const std::vector<float> cuts = composite_.cuts(depths, layers, context);
        if (classic) {
            fragments_.see_beyond(cuts[0], shot, needs, context);
            composite_.classic(fragments_, lens, cuts[0], context, frame.colour.view());
        } else {
            fragments_.see_behind(shot, needs, context);
            composite_.discs(fragments_, lens, cuts, context, frame.colour.view());
        }
        show(cuts, lens, frame, context);
        const bool known = is_public(depths.pixels());
        for (const std::string& task : context.unwritten()) {
            const bool stored = task == "layered.t1" || task == "layered.t2";
            if (!known || !stored) return hatch(frame.colour.view());
        }
    }

 private:
    void show(std::span<const float> cuts, const Lens& lens, Frame& frame, Context& context) const {
        auto& confusion = frame.plane<float>("circle of confusion", PlaneKind::scalar, "px", 0, 20);
        composite_.confusion(fragments_, lens, context, confusion.view());
        frame.plane<float>("depth", PlaneKind::scalar, "units", 0,
                           static_cast<float>(2 * lens.focal_distance)) = fragments_.depth();
        auto& layers = frame.plane<std::uint32_t>("layers", PlaneKind::id);
        for (std::size_t i = 0; i < layers.pixels().size(); ++i) {
            const float depth = fragments_.depth().pixels()[i];
            layers.pixels()[i] =
                static_cast<std::uint32_t>(std::ranges::upper_bound(cuts, depth) - cuts.begin());
        }
    }

    int mode_ = 0, layers_ = 0;
    Composite composite_;
    Fragments fragments_;
};

}  // namespace

std::unique_ptr<Technique> make(const Steps& steps, Mode) {
    return std::make_unique<Layered>(steps);
}

const std::span<const double> layers_sweep{layer_counts};

}  // namespace luch::techniques::layered
