#include "techniques/shadow_map/shadow_map.h"

#include "framework/baseline/classic.h"
#include "framework/technique/catalogue.h"

namespace luch::techniques::shadow_map {
namespace {

constexpr std::array<double, 7> sides{32, 64, 128, 256, 512, 1024, 2048};
constexpr std::array<std::string_view, 3> pattern_words{"regular", "jittered", "random"};

/// A light as points, with a map around each.
struct Lamp {
    std::vector<LightPoint> points;
    std::vector<CubeMap> maps;
};

/// What a tile asks: the lamps' maps through the steps.
class MapSource final : public ShadowSource {
 public:
    MapSource(const Steps& steps, const Params& params, std::span<const Lamp> lamps,
              Context& context)
        : steps_(&steps), params_(&params), lamps_(lamps), context_(&context) {}

    void shares(std::size_t light, std::span<const Surface> points,
                std::span<const std::uint32_t> which, std::span<float> shares) const override {
        const Lamp& lamp = lamps_[light];
        if (lamp.points.empty()) {
            std::ranges::fill(shares, unknown);
            return;
        }
        std::ranges::fill(shares, 0.0f);
        for (std::size_t i = 0; i < lamp.points.size(); ++i) {
            add_shares(lamp.points[i], lamp.maps[i], points, which, shares);
        }
    }

    [[nodiscard]] float share(std::size_t light, const Surface& surface) const override {
        const std::uint32_t first = 0;
        float share = unknown;
        shares(light, {&surface, 1}, {&first, 1}, {&share, 1});
        return share;
    }

 private:
    void add_shares(const LightPoint& point, const CubeMap& map, std::span<const Surface> points,
                    std::span<const std::uint32_t> which, std::span<float> shares) const {
        std::vector<Receiver> receivers;
        for (const std::uint32_t i : which) {
            receivers.push_back(
                {Vec3(points[i].position - point.position), Vec3(points[i].geometric_normal)});
        }
        const Steps known = reference();
        std::vector<float> biases(receivers.size()), arrives(receivers.size());
        call_step(*context_, steps_->bias, known.bias, receivers, map.n, biases);
        const auto factor = static_cast<float>(params_->bias) * (params_->pcf ? pcf_width : 1);
        for (float& bias : biases) bias *= factor;
        const auto step = params_->pcf ? steps_->pcf : steps_->lit;
        call_step(*context_, step, params_->pcf ? known.pcf : known.lit, map, receivers, biases,
                  arrives);
        for (std::size_t i = 0; i < shares.size(); ++i) shares[i] += point.share * arrives[i];
    }

    const Steps* steps_;
    const Params* params_;
    std::span<const Lamp> lamps_;
    Context* context_;
};

class ShadowMap final : public Technique {
 public:
    ShadowMap(const Steps& steps, Mode mode) : steps_(steps) {
        params_.mode = static_cast<int>(mode);
    }

    void visit(ParamVisitor& visitor) override {
        visitor.visit({"side", "texels", "Along an edge of a face of a map."}, params_.side, 1,
                      8192);
        visitor.visit({"pcf", "", "The mean of 3 × 3 comparisons, or one."}, params_.pcf);
        visitor.visit({"bias", "", "Times the bias that geometry asks for."}, params_.bias, 0.0,
                      100.0);
        visitor.visit({"points", "", "That stand for a light with an area."}, params_.points, 1,
                      1024);
        visitor.visit({"pattern", "", "Where they lie."}, params_.pattern, pattern_words);
    }

    [[nodiscard]] Plan plan(const Scene& scene, const Shot& shot) const override {
        return {true, "", classic_stages(scene, shot)};
    }

    void prepare(const Scene& scene, const Shot& shot, Context& context) override {
        lamps_.assign(scene.lights.size(), {});
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            lamps_[i].points = points_of(scene.lights[i], Key(shot.seed).branch(i), context);
            for (const LightPoint& point : lamps_[i].points) {
                lamps_[i].maps.push_back(map_around(point.position, context));
            }
        }
    }

    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        const Needs needs = needs_of(context.plan());
        const MapSource source(steps_, params_, lamps_, context);
        const KnownLightOf known = [&](const TileRays&) { return KnownLight{.shadows = &source}; };
        const auto colour = frame.colour.view();
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            trace_tile(scene, shot, tile, needs, context.tracer(worker), colour, known);
        });
        if (!needs[Part::anti_aliasing] || !may_antialias(shot)) return;
        const Image<std::uint8_t> edges = edges_of(colour, context);
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            antialias_tile(scene, shot, tile, edges.view(), needs, context.tracer(worker), colour,
                           known);
        });
    }

 private:
    [[nodiscard]] std::vector<LightPoint> points_of(const Light& light, Key key,
                                                    Context& context) const {
        std::vector<LightPoint> points;
        if (const auto* point = std::get_if<PointLight>(&light)) points = {{point->position}};
        if (const auto* spot = std::get_if<SpotLight>(&light)) points = {{spot->position}};
        if (const auto* rect = std::get_if<RectLight>(&light)) {
            call_step(context, steps_.light_points, reference().light_points, *rect, params_.points,
                      Pattern(params_.pattern), key, points);
        }
        return points;
    }

    [[nodiscard]] CubeMap map_around(const Vec3d& light, Context& context) const {
        const int n = params_.side;
        CubeMap map{n, {}};
        for (int face = 0; face < faces_of_cube; ++face) {
            Image<float>& distance = map.faces[static_cast<std::size_t>(face)].distance;
            distance = Image<float>({n, n});
            map.faces[static_cast<std::size_t>(face)].window = {0, 0, n, n};
            context.for_each_tile(distance.size(), [&](Tile tile, int worker) {
                Image<float> part({tile.width(), tile.height()});
                call_step(context, steps_.render_face, reference().render_face, light, face, n,
                          tile, context.tracer(worker), part.view());
                for_each_pixel(
                    tile, [&](int x, int y) { distance(x, y) = part(x - tile.x0, y - tile.y0); });
            });
        }
        return map;
    }

    Steps steps_;
    Params params_;
    std::vector<Lamp> lamps_;
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
            .sweep = {"side", side_sweep, -0.5}};
}

}  // namespace luch::techniques::shadow_map
