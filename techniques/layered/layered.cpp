#include "techniques/layered/layered.h"

#include "framework/baseline/classic.h"
#include "framework/technique/catalogue.h"
#include "techniques/layered/composite.h"
#include "techniques/layered/confusion.h"
#include "techniques/layered/plan.h"
#include "techniques/layered/stress.h"
#include "techniques/layered/through_lens.h"

#include <atomic>

namespace luch::techniques::layered {
namespace {

constexpr std::array<std::string_view, 3> mode_words{"lens", "discs", "classic"};
constexpr std::array<double, 7> layer_counts{2, 4, 8, 16, 32, 64, 128};

constexpr float infinite = std::numeric_limits<float>::infinity();

/// Depths that a picture has, but for the sky.
struct Depths {
    float near = infinite, far = 0;
    bool sky = false;

    void add(float depth) {
        if (depth == infinite) {
            sky = true;
            return;
        }
        near = std::min(near, depth);
        far = std::max(far, depth);
    }
};

Depths depths_of(const Fragments& fragments) {
    Depths depths;
    for (const float depth : fragments.depth().pixels()) depths.add(depth);
    for (const Hidden& hidden : fragments.hidden()) depths.add(hidden.depth);
    return depths;
}

class Layered : public Technique {
 public:
    Layered(const Steps& steps, Mode mode) : composite_(steps) {
        params_.mode = static_cast<int>(mode);
    }

    void visit(ParamVisitor& visitor) override {
        visitor.visit({"mode", "", "Lens rays through the layers, blurred discs, or two layers."},
                      params_.mode, mode_words);
        visitor.visit({"layers", "", "How many, by depth; 0: 64 (lens) or 8 (discs)."},
                      params_.layers, 0, most_layers);
        visitor.visit({"samples", "", "Points of the lens that a pixel looks through (lens)."},
                      params_.samples, 1, 4096);
        visitor.visit({"detail", "", "Sharp samples a pixel along each axis (lens)."},
                      params_.detail, 1, 8);
    }

    [[nodiscard]] Plan plan(const Scene& scene, const Shot& shot) const override {
        return plan_of(scene, shot, params_);
    }

    void prepare(const Scene& scene, const Shot&, Context& context) override {
        scene_ = &scene;
        fragments_.prepare(scene, context.plan().needed(stage::raster));
    }

    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        const Needs needs = needs_of(context.plan()).without(Part::lens);
        if (!shot.camera.has_lens()) {
            trace_frame(scene, shot, needs, context, frame.colour.view());  // the baseline
        } else if (Mode(params_.mode) == Mode::lens) {
            render_lens(shot, needs, frame, context);
        } else {
            render_layers(shot, needs, frame, context);
        }
    }

 private:
    /// The sharp picture that all modes start from.
    void look(const Shot& shot, Wish wish, const Needs& needs, Context& context) {
        wish.raster = context.plan().needed(stage::raster);
        wish.edges = context.plan().needed(stage::behind) && context.plan().needed(stage::blur);
        if (context.plan().needed(stage::blur) && !context.plan().needed(stage::detail)) {
            wish.lit_once_px = lit_once_px;
        }
        fragments_.look(shot, wish, needs, context);
        context.did(stage::detail, fragments_.lit(), "texels");
        context.did(stage::behind, fragments_.hidden().size(), "surfaces");
        if (wish.raster) context.did(stage::raster, fragments_.size().area(), "texels");
    }

    void render_lens(const Shot& shot, const Needs& needs, Frame& frame, Context& context) {
        const bool blur = context.plan().needed(stage::blur);
        Wish wish{.detail = detail_for(shot.size, params_.detail)};
        if (blur) wish.margin_px = margin_for(shot, context.tracer(0));
        look(shot, wish, needs, context);
        const Depths depths = depths_of(fragments_);
        const Lens lens = lens_of(shot.camera, shot.size);
        // A sky of one colour may stand anywhere behind all the rest.
        const float sky = !sky_is_plain(*scene_) ? infinite
                          : depths.far > 0       ? depths.far
                                                 : static_cast<float>(lens.focal_distance);
        const double near = signed_radius_px(std::min(depths.near, sky), lens);
        const double far = signed_radius_px(depths.sky ? sky : depths.far, lens);
        const Planes planes(blur ? near : 0, blur ? far : 0, layer_count(params_),
                            !context.plan().needed(stage::thin));
        const ThroughLens view(fragments_, planes, shot, sky, !context.plan().needed(stage::small));
        const LensPattern pattern(shot.seed, params_.samples);
        auto& unknown = frame.plane<float>("unknown", PlaneKind::scalar, "share");
        std::atomic<std::uint64_t> followed = 0;
        constexpr int side = 8;  // the smaller, the fewer layers are near
        context.for_each_tile(
            shot.size,
            [&](Tile tile, int) {
                followed += view.look(tile, pattern, frame.colour.view(), unknown.view());
            },
            side);
        if (blur) context.did(stage::blur, followed, "lens rays");
        if (!context.budget().planes) return;
        show(shot, frame, [&](float depth) {
            const float place = planes.position(signed_radius_px(std::min(depth, sky), lens));
            return static_cast<std::uint32_t>(std::lround(place));
        });
    }

    void render_layers(const Shot& shot, const Needs& needs, Frame& frame, Context& context) {
        const bool classic = Mode(params_.mode) == Mode::classic;
        look(shot, {}, needs, context);
        Image<float> depths = fragments_.depth();
        if (classic) {
            // What is nearer than the plane of focus is foreground anyway.
            const auto focus = static_cast<float>(shot.camera.focal_distance);
            for (float& depth : depths.pixels()) depth = std::max(depth, focus);
        }
        const std::vector<float> cuts = composite_.cuts(depths, layer_count(params_), context);
        if (context.budget().planes) {
            show(shot, frame, [&](float depth) {
                return static_cast<std::uint32_t>(std::ranges::upper_bound(cuts, depth) -
                                                  cuts.begin());
            });
        }
        if (!context.plan().needed(stage::blur)) {
            frame.colour = fragments_.colour();
            return;
        }
        const Lens lens = lens_of(shot.camera, shot.size);
        if (classic) {
            look(shot, {.behind = cuts[0]}, needs, context);
            composite_.classic(fragments_, lens, cuts[0], context, frame.colour.view());
        } else {
            composite_.discs(fragments_, lens, cuts, context, frame.colour.view());
        }
        context.did(stage::blur, cuts.size() + 1, "layers");
    }

    /// Depth, circle of confusion, layer and what is behind of the texel in each pixel's middle.
    template <class LayerOf>
    void show(const Shot& shot, Frame& frame, LayerOf&& layer_of) const {
        const Lens lens = lens_of(shot.camera, shot.size);
        auto& depth = frame.plane<float>("depth", PlaneKind::scalar, "units", 0,
                                         static_cast<float>(2 * lens.focal_distance));
        auto& confusion = frame.plane<float>("circle of confusion", PlaneKind::scalar, "px", 0, 20);
        auto& layers = frame.plane<std::uint32_t>("layers", PlaneKind::id);
        auto& behind = frame.plane<std::uint8_t>("behind", PlaneKind::mask);
        const Wish& wish = fragments_.wish();
        for (int y = 0; y < shot.size.height; ++y) {
            for (int x = 0; x < shot.size.width; ++x) {
                const int i = (x + wish.margin_px) * wish.detail + wish.detail / 2;
                const int j = (y + wish.margin_px) * wish.detail + wish.detail / 2;
                const float z = fragments_.depth()(i, j);
                depth(x, y) = z;
                confusion(x, y) = static_cast<float>(2 * std::abs(signed_radius_px(z, lens)));
                layers(x, y) = layer_of(z);
                behind(x, y) = fragments_.behind(i, j) != Fragments::none;
            }
        }
    }

    const Scene* scene_ = nullptr;
    Params params_;
    Composite composite_;
    Fragments fragments_;
};

}  // namespace

int layer_count(const Params& params) {
    switch (Mode(params.mode)) {
        case Mode::lens:
            return params.layers > 0 ? params.layers : 64;
        case Mode::discs:
            return params.layers > 0 ? params.layers : 8;
        case Mode::classic:
            break;
    }
    return 2;
}

std::unique_ptr<Technique> make(const Steps& steps, Mode mode) {
    return std::make_unique<Layered>(steps, mode);
}

const std::span<const double> layers_sweep{layer_counts};

TechniqueInfo describe() {
    return {.name = "layered",
            .title = "depth of field from sharp layers",
            .topic = "4. layers and depth of field",
            .create = [] { return make(reference(), Mode::lens); },
            .sweep = {"layers", layers_sweep},
            .whole_lens = true,
            .stress_cases = stress_cases};
}

}  // namespace luch::techniques::layered
