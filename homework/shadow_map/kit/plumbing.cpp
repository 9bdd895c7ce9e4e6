// The students' kit: what calls the steps, in the place of techniques/shadow_map, which holds
// solutions. It has the lecture's maps, without what makes them quick or exact. Where a step is not
// written something simple stands in (stand_ins.cpp), and the picture is hatched.
#include "framework/baseline/classic.h"
#include "techniques/shadow_map/content.h"
#include "techniques/shadow_map/judged.h"
#include "techniques/shadow_map/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace luch::techniques::shadow_map {
namespace {

constexpr std::array<double, 7> sides{32, 64, 128, 256, 512, 1024, 2048};
constexpr std::array<std::string_view, 3> pattern_words{"regular", "jittered", "random"};

/// Stripes over a picture that is not what it will be.
void hatch(ImageView<Rgb> colour) {
    constexpr int stripe = 4;
    for (int y = 0; y < colour.height(); ++y) {
        for (int x = 0; x < colour.width(); ++x) {
            if ((x + y) / stripe % 2 != 0) colour(x, y) *= 0.4f;
        }
    }
}

/// A light as points, each with its map.
struct Lamps {
    std::vector<LightPoint> points;  ///< none: shadow rays shall tell
    std::vector<CubeMap> maps;
    Vec3d facing{0};  ///< of a light with an area; else zero
    int n = 1;        ///< texels along an edge of a face
};

/// What a point of a light with an area would send to a surface were nothing in between, but for a
/// factor.
float unhindered(const Surface& surface, const LightPoint& point, const Vec3d& facing) {
    const Vec3d way = surface.position - point.position;
    const double squared = glm::dot(way, way);
    const double leaves = glm::dot(facing, way), arrives = -glm::dot(surface.normal, way);
    if (!(leaves > 0 && arrives > 0)) return 0;
    return static_cast<float>(leaves * arrives / (squared * squared)) * point.share;
}

class MapSource final : public ShadowSource {
 public:
    MapSource(const Steps& steps, const Params& params, std::span<const Lamps> lights,
              Context& context)
        : steps_(steps), params_(params), lights_(lights), context_(&context) {}

    void shares(std::size_t light, std::span<const Surface> points,
                std::span<const std::uint32_t> which, std::span<float> shares) const override {
        const Lamps& lamps = lights_[light];
        if (lamps.points.empty()) {
            std::ranges::fill(shares, unknown);
            return;
        }
        std::vector<Surface> asked;
        for (const std::uint32_t i : which) asked.push_back(points[i]);
        if (lamps.facing == Vec3d(0)) return ask(lamps, 0, asked, shares);
        std::vector<float> arrives(shares.size()), whole(shares.size(), 0.0f);
        std::ranges::fill(shares, 0.0f);
        for (std::size_t lamp = 0; lamp < lamps.points.size(); ++lamp) {
            ask(lamps, lamp, asked, arrives);
            for (std::size_t i = 0; i < shares.size(); ++i) {
                const float weight = unhindered(asked[i], lamps.points[lamp], lamps.facing);
                shares[i] += weight * arrives[i];
                whole[i] += weight;
            }
        }
        for (std::size_t i = 0; i < shares.size(); ++i) {
            if (whole[i] > 0) shares[i] = std::min(shares[i] / whole[i], 1.0f);
        }
    }

    [[nodiscard]] float share(std::size_t light, const Surface& surface) const override {
        const std::uint32_t first = 0;
        float share = unknown;
        shares(light, {&surface, 1}, {&first, 1}, {&share, 1});
        return share;
    }

 private:
    void ask(const Lamps& lamps, std::size_t lamp, std::span<const Surface> surfaces,
             std::span<float> shares) const {
        const CubeMap& map = lamps.maps[lamp];
        std::vector<Receiver> receivers;
        for (const Surface& each : surfaces) {
            receivers.push_back(
                {Vec3(each.position - lamps.points[lamp].position), Vec3(each.geometric_normal)});
        }
        std::vector<float> biases(receivers.size());
        call_step(*context_, steps_.bias, reference().bias, receivers, map.n, biases);
        const auto factor = static_cast<float>(params_.bias) * (params_.pcf ? pcf_width : 1);
        for (float& bias : biases) bias *= factor;
        call_step(*context_, params_.pcf ? steps_.pcf : steps_.lit,
                  params_.pcf ? reference().pcf : reference().lit, map, receivers, biases, shares);
    }

    Steps steps_;
    Params params_;
    std::span<const Lamps> lights_;
    Context* context_;
};

/// The steps that a frame asks for every point; something stands in where there are holes. One call
/// with nothing to do tells: a hole for each point would take longer than the picture.
Steps asked_steps(const Steps& steps, bool filter, Context& context) {
    Steps asked = steps;
    const CubeMap none{1, {}};
    if (!written(context, [&] { steps.bias({}, 1, {}); })) asked.bias = reference().bias;
    if (filter) {
        if (!written(context, [&] { steps.pcf(none, {}, {}, {}); })) asked.pcf = reference().pcf;
    } else if (!written(context, [&] { steps.lit(none, {}, {}, {}); })) {
        asked.lit = reference().lit;
    }
    return asked;
}

/// The faces of a map, 0, 1, 2 above 3, 4, 5; near things are bright, blue is infinity.
void unwrap(const CubeMap& map, ImageView<Rgb> colour) {
    float nearest = std::numeric_limits<float>::infinity();
    for (const Face& face : map.faces) {
        nearest = std::min(nearest, *std::ranges::min_element(face.distance.pixels()));
    }
    for (int y = 0; y < colour.height(); ++y) {
        for (int x = 0; x < colour.width(); ++x) {
            const int u = 3 * map.n * x / colour.width(), v = 2 * map.n * y / colour.height();
            const float distance = map.at({v / map.n * 3 + u / map.n, u % map.n, v % map.n});
            colour(x, y) = std::isinf(distance) ? Rgb(0.02f, 0.04f, 0.2f) : Rgb(nearest / distance);
        }
    }
}

class ShadowMap final : public Technique {
 public:
    explicit ShadowMap(const Steps& steps) : steps_(steps) {}

    void visit(ParamVisitor& visitor) override {
        visitor.visit({"side", "texels", "Along an edge of a face of a map."}, params_.side, 1,
                      4096);
        visitor.visit({"pcf", "", "The mean of 3 × 3 comparisons, or one."}, params_.pcf);
        visitor.visit({"bias", "", "Times the bias that geometry asks for."}, params_.bias, 0.0,
                      100.0);
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
        return {true, "a comparison with a map in the place of each shadow ray",
                classic_stages(scene, shot)};
    }

    void prepare(const Scene& scene, const Shot& shot, Context& context) override {
        std::vector<Lamps> lights(scene.lights.size());
        Key made_from(Content(scene).digest());
        double left = params_.memory * 0x1p20 / sizeof(float);  // texels
        for (std::size_t i = 0; i < lights.size(); ++i) {
            Lamps& lamps = lights[i];
            place(scene.lights[i], Key(shot.seed).branch(i), lamps, context);
            // The points of a light with an area share the texels of one map.
            const bool many = std::holds_alternative<RectLight>(scene.lights[i]);
            const int side = static_cast<int>(params_.side / std::sqrt(many ? params_.points : 1));
            lamps.n = std::max(side, 1);
            const double texels =
                6.0 * lamps.n * lamps.n * static_cast<double>(lamps.points.size());
            if (texels > left) lamps = {};  // its shadows are left to rays
            left -= lamps.points.empty() ? 0 : texels;
            made_from = followed(made_from.branch(i), lamps.n);
            for (const LightPoint& each : lamps.points) {
                made_from = followed(made_from, each.position);
            }
        }
        // What stands still is looked at once.
        if (made_from_ == made_from.bits(0)) return;
        lights_ = std::move(lights);
        for (Lamps& lamps : lights_) {
            for (const LightPoint& point : lamps.points) {
                lamps.maps.push_back(map_around(point.position, lamps.n, context));
            }
        }
        made_from_.reset();
        if (context.unwritten().empty()) made_from_ = made_from.bits(0);
    }

    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        const auto first =
            std::ranges::find_if(lights_, [](const Lamps& lamps) { return !lamps.maps.empty(); });
        if (params_.unwrap && first != lights_.end()) {
            unwrap(first->maps[0], frame.colour.view());
        } else {
            draw(scene, shot, frame, context);
        }
        if (!context.unwritten().empty()) hatch(frame.colour.view());
    }

 private:
    void draw(const Scene& scene, const Shot& shot, Frame& frame, Context& context) const {
        const Steps steps = asked_steps(steps_, params_.pcf, context);
        const MapSource source(steps, params_, lights_, context);
        const ShadowPlanes planes(frame, context.budget().planes, params_.judge);
        std::vector<JudgedSource> judged;
        for (int i = 0; i < context.workers(); ++i) {
            judged.emplace_back(source, scene, context.tracer(i), planes);
        }
        trace_frame(scene, shot, needs_of(context.plan()), context, frame.colour.view(),
                    [&](int worker) {
                        JudgedSource& own = judged[static_cast<std::size_t>(worker)];
                        return [&own](const TileRays& rays) {
                            own.look_at(rays);
                            return KnownLight{.shadows = &own};
                        };
                    });
    }

    void place(const Light& light, Key key, Lamps& lamps, Context& context) const {
        if (const auto* point = std::get_if<PointLight>(&light)) {
            lamps.points = {{point->position}};
        } else if (const auto* spot = std::get_if<SpotLight>(&light)) {
            lamps.points = {{spot->position}};
        } else if (const auto* rect = std::get_if<RectLight>(&light)) {
            lamps.facing = rect->facing();
            call_step(context, steps_.light_points, reference().light_points, *rect, params_.points,
                      Pattern(params_.pattern), key, lamps.points);
        }
    }

    [[nodiscard]] CubeMap map_around(const Vec3d& light, int n, Context& context) const {
        CubeMap map{n, {}};
        for (int face = 0; face < faces_of_cube; ++face) {
            auto& [window, distance] = map.faces[static_cast<std::size_t>(face)];
            window = {0, 0, n, n};
            distance = Image<float>({n, n});
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
    std::vector<Lamps> lights_;
    std::optional<std::uint64_t> made_from_;  ///< what the maps depend on, were no hole met
};

}  // namespace

std::unique_ptr<Technique> make(const Steps& steps, Mode) {
    return std::make_unique<ShadowMap>(steps);
}

const std::span<const double> side_sweep{sides};

}  // namespace luch::techniques::shadow_map
