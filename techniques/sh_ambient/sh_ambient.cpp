#include "techniques/sh_ambient/sh_ambient.h"

#include "framework/baseline/classic.h"
#include "framework/technique/catalogue.h"
#include "techniques/sh_ambient/fingerprint.h"
#include "techniques/sh_ambient/plan.h"
#include "techniques/sh_ambient/probes.h"
#include "techniques/sh_ambient/source.h"
#include "techniques/sh_ambient/stress.h"

namespace luch::techniques::sh_ambient {
namespace {

constexpr std::array<std::string_view, 4> mode_words{"environment", "probes", "sampled", "traced"};
constexpr std::array<std::string_view, 3> ringing_words{"off", "least", "scaled"};
constexpr std::array<std::string_view, 3> leak_words{"shown", "normals", "distances"};
constexpr std::array<double, 3> degrees{0, 1, 2};

constexpr std::uint32_t no_probe = ~std::uint32_t{0};  // nothing was seen, or nothing asked
constexpr float mark_px = 3;

/// What random numbers are drawn for, by the frame's seed.
enum Purpose : std::uint64_t { of_points, of_probes };

class ShAmbient : public Technique {
 public:
    ShAmbient(const Steps& steps, const Params& params) : steps_(steps), params_(params) {}

    void visit(ParamVisitor& visitor) override {
        visitor.visit(
            {"mode", "", "Of the sky, or of probes in the scene; or the truth of either."},
            params_.mode, mode_words);
        visitor.visit({"degree", "", "Of the harmonics (environment)."}, params_.degree, 0, 2);
        visitor.visit({"ringing", "", "What keeps irradiance from falling below 0."},
                      params_.ringing, ringing_words);
        visitor.visit({"samples", "", "Directions a point (sampled, traced)."}, params_.samples, 1,
                      1 << 20);
        visitor.visit({"probes", "", "Along the longest side of the grid."}, params_.probes, 1,
                      most_probes);
        visitor.visit({"rays", "", "From each probe."}, params_.rays, 1, 1 << 20);
        visitor.visit({"bounces", "", "Surfaces that reflect light on its way (probes, traced)."},
                      params_.bounces, 0, 64);
        visitor.visit({"leaks", "", "What is done against light through walls (probes)."},
                      params_.leaks, leak_words);
    }

    [[nodiscard]] Plan plan(const Scene& scene, const Shot& shot) const override {
        return plan_of(scene, shot, params_, sky_of(scene).light);
    }

    void prepare(const Scene& scene, const Shot& shot, Context& context) override {
        const Plan& plan = context.plan();
        if (!plan.needed(stage::ambient)) return;
        if (Mode(params_.mode) == Mode::environment) {
            const KnownSky& known = sky_of(scene);
            if (known.fresh) {
                context.did(stage::projection, known.light.texels, "texels");
                context.did(stage::wild, known.light.wild, "texels");
                known.fresh = false;
            }
            const auto ringing =
                plan.needed(stage::ringing) ? Ringing(params_.ringing) : Ringing::off;
            sky_ = tamed(known.light.light, degree_left(plan, params_), ringing);
        }
        if (Mode(params_.mode) == Mode::probes) prepare_probes(scene, shot, context);
    }

    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        Ambience ambience{scene, steps_, params_, needs_of(context.plan())};
        ambience.any = context.plan().needed(stage::ambient);
        ambience.sky = sky_;
        ambience.grid = &grid_;
        ambience.key = Key(shot.seed).branch(of_points);
        const Planes planes = context.budget().planes ? planes_of(frame) : Planes{};
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            TileAmbient source(ambience, context, context.tracer(worker), planes);
            trace_tile(scene, shot, tile, ambience.needs, context.tracer(worker),
                       frame.colour.view(), known(source));
        });
        if (ambience.needs[Part::anti_aliasing] && may_antialias(shot)) {
            antialias(shot, ambience, frame, context);
        }
        context.did(stage::ambient, ambience.points, "points");
        context.did(stage::ringing, ambience.negative, "points below 0");
        if (context.budget().planes) mark_probes(shot, frame);
    }

 private:
    /// The sky that was projected last.
    struct KnownSky {
        std::uint64_t fingerprint = 0;
        bool known = false;
        mutable bool fresh = false;  ///< no frame has told of it yet
        SkyLight light;
    };
    /// The probes that were filled last: of which scene, with which parameters.
    struct KnownProbes {
        std::uint64_t fingerprint = 0, seed = 0;
        int along = 0, rays = 0, bounces = 0, leaks = 0, ringing = 0;
        Vec3d first{0};
        bool operator==(const KnownProbes&) const = default;
    };

    [[nodiscard]] const KnownSky& sky_of(const Scene& scene) const {
        const std::uint64_t fingerprint = sky_fingerprint(scene);
        if (!known_sky_.known || known_sky_.fingerprint != fingerprint) {
            known_sky_ = {fingerprint, true, true, sky_light_of(scene, steps_)};
        }
        return known_sky_;
    }

    void prepare_probes(const Scene& scene, const Shot& shot, Context& context) {
        ProbeGrid grid = grid_around(scene, shot.camera.position, params_.probes);
        const KnownProbes wanted{
            scene_fingerprint(scene), shot.seed,     params_.probes,  params_.rays,
            params_.bounces,          params_.leaks, params_.ringing, grid.place(0)};
        if (known_probes_ == wanted) return;
        known_probes_.reset();
        const bool filled = fill(grid, scene, params_, needs_of(context.plan()),
                                 Key(shot.seed).branch(of_probes), steps_, context);
        if (!filled) return;
        grid_ = std::move(grid);
        known_probes_ = wanted;
        context.did(stage::probes, grid_.bytes(), "bytes");
        context.did(stage::distances, grid_.distances.size(), "maps");
    }

    static KnownLightOf known(TileAmbient& source) {
        return [&source](const TileRays& rays) {
            source.look(rays);
            return KnownLight{.ambient = &source};
        };
    }

    [[nodiscard]] Planes planes_of(Frame& frame) const {
        Planes planes;
        auto& irradiance = frame.plane<Rgb>("irradiance", PlaneKind::colour);
        std::ranges::fill(irradiance.pixels(), Rgb(0));
        planes.irradiance = irradiance.view();
        if (Mode(params_.mode) != Mode::probes) return planes;
        auto& probe = frame.plane<std::uint32_t>("probe", PlaneKind::id);
        auto& weight = frame.plane<float>("probe weight", PlaneKind::scalar, "share");
        std::ranges::fill(probe.pixels(), no_probe);
        std::ranges::fill(weight.pixels(), 0.0f);
        planes.probe = probe.view();
        planes.weight = weight.view();
        return planes;
    }

    /// The scene's own anti-aliasing, with the same ambient light.
    static void antialias(const Shot& shot, Ambience& ambience, Frame& frame, Context& context) {
        const Image<std::uint8_t> edges = edges_of(frame.colour.view(), context);
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            TileAmbient source(ambience, context, context.tracer(worker));
            antialias_tile(ambience.scene, shot, tile, edges.view(), ambience.needs,
                           context.tracer(worker), frame.colour.view(), known(source));
        });
    }

    /// A square for every probe, in the colour of what comes in there on average.
    void mark_probes(const Shot& shot, Frame& frame) const {
        frame.marks.clear();
        if (Mode(params_.mode) != Mode::probes) return;
        const Screen screen(shot.camera, shot.size);
        const float mean = harmonics(Vec3(0, 0, 1))[0];
        for (std::size_t i = 0; i < grid_.light.size(); ++i) {
            const auto at = screen.project(screen.to_view(grid_.place(i)));
            if (!at) continue;
            const Vec2 px(*at);
            frame.marks.push_back({Mark::rectangle, px.x - mark_px, px.y - mark_px, px.x + mark_px,
                                   px.y + mark_px, grid_.light[i].l[0] * mean});
        }
    }

    Steps steps_;
    Params params_;
    mutable KnownSky known_sky_;
    Sh9 sky_;
    std::optional<KnownProbes> known_probes_;
    ProbeGrid grid_;
};

}  // namespace

std::unique_ptr<Technique> make(const Steps& steps, const Params& params) {
    return std::make_unique<ShAmbient>(steps, params);
}

const std::span<const double> degree_sweep{degrees};

TechniqueInfo describe() {
    return {.name = "sh_ambient",
            .title = "ambient light from spherical harmonics",
            .topic = "6. ambient light",
            .create = [] { return make(reference()); },
            .sweep = {"degree", degree_sweep},
            .approximates = false,
            .truth = "mode=sampled",
            .stress_cases = stress_cases};
}

}  // namespace luch::techniques::sh_ambient
