#include "framework/trace/path.h"

#include "framework/baseline/stages.h"
#include "framework/technique/context.h"
#include "framework/math/spread.h"
#include "framework/technique/catalogue.h"

#include <array>
#include <limits>

namespace luch::path {
namespace {

/// What a pixel's key is used for beside its bounces, which count from 0.
enum Purpose : std::uint64_t { place = ~std::uint64_t{0}, lens = ~std::uint64_t{1} };

constexpr int most_groups = 16;

/// A double that a float can hold; what is not finite stays so.
float float_of(double value) {
    constexpr double most = std::numeric_limits<float>::max();
    return static_cast<float>(std::isfinite(value) ? std::clamp(value, -most, most) : value);
}

Rgb rgb_of(const Vec3d& colour) {
    return {float_of(colour.x), float_of(colour.y), float_of(colour.z)};
}

/// A pixel's samples so far: their mean, and how far the groups' means are spread around it
/// (Welford's way of adding up, 1962, with weights).
struct Estimate {
    Vec3d mean{0};
    Vec3d spread{0};  ///< Σ n·(group's mean − mean)²

    void add(const Vec3d& group_mean, int samples, int samples_before) {
        const Vec3d off = group_mean - mean;
        mean += off * (static_cast<double>(samples) / (samples_before + samples));
        spread += static_cast<double>(samples) * off * (group_mean - mean);
    }
};

int samples_of(const Scene& scene, const Shot& shot) {
    if (shot.spp > 0) return shot.spp;
    return std::max(scene.settings.paths, shot.camera.has_lens() ? shot.camera.lens_samples : 1);
}

/// Within a group samples are spread evenly, between groups they are independent.
int groups_of(int samples) {
    if (samples == 1) return 1;
    return std::clamp(static_cast<int>(std::sqrt(static_cast<double>(samples))), 2, most_groups);
}

/// Path tracing, the truth where a scene asks for global illumination.
///
/// A pixel's samples form up to 16 groups of equal size. Those of one group are spread evenly over
/// the pixel, the lens and every decision of the path (an Owen-scrambled (0, 2)-sequence for each
/// pair of dimensions), so their own variance would say too much about the error; the groups' means
/// are independent, and the standard error comes from them. It is honest for any number of samples,
/// but with few groups rough: its square has (groups − 1) degrees of freedom.
class Path final : public Technique {
 public:
    void visit(ParamVisitor& visitor) override {
        static constexpr std::array<std::string_view, 3> ways{"both", "light", "bsdf"};
        visitor.visit(
            {"mis", "", "weighs light and BSDF sampling by their densities; off: by halves"}, mis_);
        visitor.visit({"sampling", "", "how light is found where both ways can"}, sampling_, ways);
        visitor.visit({"roulette", "", "ends paths that carry little light"}, roulette_);
        visitor.visit({"depth", "bounces", "how long a path may be; -1: as the scene says"}, depth_,
                      -1, 1'000'000);
    }

    Plan plan(const Scene& scene, const Shot& shot) const override {
        return {.applies = true, .why = "", .stages = path_stages(scene, shot)};
    }

    void prepare(const Scene& scene, const Shot&, Context&) override { lights_.emplace(scene); }

    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override;

 private:
    [[nodiscard]] PathSettings settings(const Scene& scene) const {
        return {.sampling = static_cast<PathSampling>(sampling_),
                .mis = mis_,
                .roulette = roulette_,
                .depth = depth_ < 0 ? scene.settings.max_depth : depth_};
    }

    bool mis_ = true;
    int sampling_ = 0;
    bool roulette_ = true;
    int depth_ = -1;
    std::optional<PathLights> lights_;
};

/// One group of samples, added to the estimates of a tile's pixels.
struct Group {
    const Shot& shot;
    const Screen& screen;
    PathTracer& tracer;
    bool lens;
    int index;
    int samples;
    int samples_before;
    int samples_in_all;

    void add_to(Estimate& estimate, int x, int y) const {
        const Key key = Key(shot.seed)
                            .branch(static_cast<std::uint64_t>(y) * shot.size.width + x)
                            .branch(static_cast<std::uint64_t>(index));
        Vec3d sum(0);
        for (int i = 0; i < samples; ++i) {
            const Draw draw{key, static_cast<std::uint32_t>(i)};
            const Ray ray = camera_ray(draw, x, y);
            if (!nowhere(ray)) sum += tracer.radiance(ray, draw);
        }
        estimate.add(sum / static_cast<double>(samples), samples, samples_before);
    }

 private:
    [[nodiscard]] Ray camera_ray(const Draw& draw, int x, int y) const {
        const Vec2d inside = samples_in_all == 1 ? Vec2d(0.5) : draw.pair(place);
        const Vec2d at = Vec2d(x, y) + inside;
        if (!lens) return screen.ray(at.x, at.y);
        return screen.ray(at.x, at.y, disc_of(draw.pair(path::lens)));
    }
};

void Path::render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) {
    const Needs needs = needs_of(context.plan());
    const int samples = samples_of(scene, shot), groups = groups_of(samples);
    const Screen screen(shot.camera, shot.size);
    auto& error = frame.plane<Rgb>("standard error", PlaneKind::colour, "radiance");
    Image<Estimate> estimates(shot.size);
    int before = 0;
    for (int group = 0; group < groups; ++group) {
        const int here = (samples - before) / (groups - group);
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            PathTracer tracer(scene, *lights_, settings(scene), needs, context.tracer(worker));
            const Group work{shot, screen, tracer, needs[Part::lens], group, here, before, samples};
            for (int y = tile.y0; y < tile.y1; ++y) {
                for (int x = tile.x0; x < tile.x1; ++x) {
                    Estimate& estimate = estimates(x, y);
                    work.add_to(estimate, x, y);
                    frame.colour(x, y) = rgb_of(estimate.mean);
                    const double known = static_cast<double>(group) * (before + here);
                    error(x, y) = rgb_of(glm::sqrt(glm::max(estimate.spread, 0.0) / known));
                }
            }
        });
        if (context.cancelled()) return;
        before += here;
        if (context.budget().on_part) context.budget().on_part(double(before) / samples);
    }
    // Nothing is known of the error of a single sample.
    if (groups == 1) error = Image<Rgb>(shot.size, Rgb(std::numeric_limits<float>::infinity()));
}

}  // namespace

TechniqueInfo describe() {
    return {.name = "path",
            .title = "path tracing, the ground truth of gi",
            .topic = "1. classic ray tracing",
            .create = []() -> std::unique_ptr<Technique> { return std::make_unique<Path>(); },
            .sweep = {samples_parameter, samples_sweep, -0.5},
            .approximates = false};
}

}  // namespace luch::path
