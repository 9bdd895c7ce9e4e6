#include "techniques/ssao/render.h"

#include "framework/baseline/classic.h"
#include "techniques/ssao/ambient.h"
#include "techniques/ssao/passes.h"
#include "techniques/ssao/plan.h"
#include "techniques/ssao/rays.h"
#include "techniques/ssao/view.h"

#include <array>

namespace luch::techniques::ssao {
namespace {

constexpr std::array<std::string_view, 4> mode_words{"bitmask", "gtao", "classic", "rays"};
constexpr std::array<std::string_view, 3> smoothing_words{"edges", "gaussian", "off"};
constexpr std::array<std::string_view, 2> normal_words{"surface", "picture"};
constexpr std::array<std::string_view, 2> show_words{"picture", "visibility"};

/// The frame's colours, of how much of the ambient light arrives.
void show_visibility(const Image<float>& visibility, Image<Rgb>& colour) {
    for (std::size_t i = 0; i < visibility.pixels().size(); ++i) {
        colour.pixels()[i] = Rgb(visibility.pixels()[i]);
    }
}

class Ssao : public Technique {
 public:
    Ssao(const Steps& steps, const Params& params) : params_(params), passes_(steps) {}

    void visit(ParamVisitor& visitor) override {
        visitor.visit({"mode", "", "Sectors, horizons, points, or rays (the truth)."}, params_.mode,
                      mode_words);
        visitor.visit({"samples", "", "A pixel; 0: 18, classic 32, rays 256."}, params_.samples, 0,
                      65536);
        visitor.visit({"radius", "units", "What is farther hides nothing; 0: by the scene."},
                      params_.radius, 0, 1e15);
        visitor.visit({"thickness", "radii", "Of what is seen (bitmask)."}, params_.thickness, 0,
                      1e6);
        visitor.visit({"fade", "", "What is far hides less, as published (gtao)."}, params_.fade);
        visitor.visit({"half", "", "At half of the resolution, upsampled along edges."},
                      params_.half);
        visitor.visit({"blur", "", "Within surfaces, across edges, or not at all."},
                      params_.smoothing, smoothing_words);
        visitor.visit({"normals", "", "Of the surfaces, or found in the picture."}, params_.normals,
                      normal_words);
        visitor.visit({"show", "", "The picture, or how much ambient light arrives."}, params_.show,
                      show_words);
    }

    [[nodiscard]] Plan plan(const Scene& scene, const Shot& shot) const override {
        return plan_of(scene, shot, params_);
    }

    void prepare(const Scene& scene, const Shot&, Context&) override {
        settled_ = settled(params_, scene);
    }

    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        const Plan& plan = context.plan();
        const bool rays = Mode(settled_.mode) == Mode::rays;
        const bool occluded = plan.needed(stage::occlusion) && plan.needed(stage::convex) &&
                              (rays || plan.needed(stage::small));
        auto& visibility = frame.plane<float>("visibility", PlaneKind::scalar, "share");
        std::ranges::fill(visibility.pixels(), 1.0f);
        if (rays) {
            render_rays(scene, shot, occluded, frame, context);
        } else {
            render_passes(scene, shot, occluded, frame, context);
        }
    }

 private:
    void render_rays(const Scene& scene, const Shot& shot, bool occluded, Frame& frame,
                     Context& context) const {
        const Params& params = settled_;
        auto& visibility = frame.plane<float>("visibility", PlaneKind::scalar, "share");
        if (Show(params.show) == Show::visibility) {
            if (occluded) trace_visibility(scene, shot, params, context, visibility);
            return show_visibility(visibility, frame.colour);
        }
        shade(scene, shot, nullptr, frame, context, [&](const TileRays& rays, Tracer& tracer) {
            return occluded ? std::make_unique<TracedAmbient>(scene.settings.ambient_light, params,
                                                              rays, tracer, visibility.view())
                            : nullptr;
        });
        if (occluded) context.did(stage::occlusion, visibility.pixels().size(), "pixels");
    }

    void trace_visibility(const Scene& scene, const Shot& shot, const Params& params,
                          Context& context, Image<float>& visibility) const {
        Shot centres = shot;
        centres.spp = 1;
        const Needs needs = needs_of(context.plan());
        const Screen screen(shot.camera, shot.size);
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            TileRays rays;
            Tracer& tracer = context.tracer(worker);
            rays.shoot(screen, centres, tile, 0, needs, tracer);
            const TracedAmbient ambient(Rgb(1), params, rays, tracer, visibility.view());
            for (std::size_t i = 0; i < rays.rays.size(); ++i) {
                if (!rays.hits[i]) continue;
                (void)ambient.at(surface_at(scene, rays.rays[i], rays.hits[i]), i);
            }
        });
        context.did(stage::occlusion, visibility.pixels().size(), "pixels");
    }

    void render_passes(const Scene& scene, const Shot& shot, bool occluded, Frame& frame,
                       Context& context) {
        const Params& params = settled_;
        passes_.look(scene, shot, params, needs_of(context.plan()), context);
        if (occluded) {
            passes_.occlude(shot, params, context);
            context.did(stage::occlusion, passes_.raw().pixels().size(), "pixels");
        } else {
            passes_.all_visible();
        }
        show_passes(params, frame);  // the kit tells public scenes by their depths
        if (Show(params.show) == Show::visibility) {
            return show_visibility(passes_.visibility(), frame.colour);
        }
        passes_.light(scene.settings.ambient_light, context);
        const AmbientPlane plane{scene.settings.ambient_light, passes_.light().view(),
                                 passes_.position().view()};
        const Screen screen(shot.camera, shot.size);
        const bool centres = sample_count(shot) == 1;
        shade(scene, shot, centres ? &passes_.hits() : nullptr, frame, context,
              [&](const TileRays& rays, Tracer&) {
                  const bool own = centres && is_of_centres(screen, rays);
                  return occluded ? std::make_unique<PlaneAmbient>(plane, screen, rays, own)
                                  : nullptr;
              });
    }

    static bool is_of_centres(const Screen& screen, const TileRays& rays) {
        if (rays.rays.empty()) return true;
        const auto& [x, y] = rays.pixels[0];
        return rays.rays[0].direction == screen.ray(x + 0.5, y + 0.5).direction;
    }

    /// The baseline's picture, with ambient light by source_of(rays, tracer); null: the scene's.
    template <class SourceOf>
    static void shade(const Scene& scene, const Shot& shot, const Image<Hit>* hits, Frame& frame,
                      Context& context, SourceOf&& source_of) {
        const Needs needs = needs_of(context.plan());
        const ImageView<Rgb> colour = frame.colour.view();
        const auto with_known = [&](Tracer& tracer, auto&& work) {
            std::unique_ptr<AmbientSource> source;
            work([&](const TileRays& rays) {
                source = source_of(rays, tracer);
                return KnownLight{.ambient = source.get()};
            });
        };
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            Tracer& tracer = context.tracer(worker);
            with_known(tracer, [&](const KnownLightOf& known) {
                if (hits != nullptr) {
                    shade_tile(scene, shot, tile, needs, tracer, hits->view(), colour, known);
                } else {
                    trace_tile(scene, shot, tile, needs, tracer, colour, known);
                }
            });
        });
        if (!needs[Part::anti_aliasing] || !may_antialias(shot)) return;
        const Image<std::uint8_t> edges = edges_of(colour, context);
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            Tracer& tracer = context.tracer(worker);
            with_known(tracer, [&](const KnownLightOf& known) {
                antialias_tile(scene, shot, tile, edges.view(), needs, tracer, colour, known);
            });
        });
    }

    void show_passes(const Params& params, Frame& frame) const {
        const auto far = static_cast<float>(20 * params.radius);
        frame.plane<float>("depth", PlaneKind::scalar, "units", 0, far) = passes_.depth();
        frame.plane<Rgb>("position", PlaneKind::colour, "units") = passes_.position();
        frame.plane<Rgb>("normal", PlaneKind::normal) = passes_.normal();
        frame.plane<float>("visibility", PlaneKind::scalar, "share") = passes_.visibility();
        show_pass("raw occlusion", passes_.raw(), frame);
        show_pass("blurred occlusion", passes_.blurred(), frame);
    }

    /// At half size a pixel stands for four.
    static void show_pass(const char* name, const Image<float>& pass, Frame& frame) {
        auto& plane = frame.plane<float>(name, PlaneKind::scalar, "share");
        const int step = pass.size() == frame.size() ? 1 : 2;
        each_pixel(plane.view().tile(),
                   [&](int x, int y) { plane(x, y) = pass(x / step, y / step); });
    }

    Params params_;   ///< as the user set them
    Params settled_;  ///< of the scene that was prepared
    Passes passes_;
};

}  // namespace

std::unique_ptr<Technique> technique_of(const Steps& steps, const Params& params) {
    return std::make_unique<Ssao>(steps, params);
}

}  // namespace luch::techniques::ssao
