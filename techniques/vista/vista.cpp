#include "techniques/vista/vista.h"

#include "framework/baseline/classic.h"
#include "framework/technique/catalogue.h"
#include "techniques/vista/buffer.h"
#include "techniques/vista/exact.h"
#include "techniques/vista/plan.h"

#include <atomic>
#include <bit>

namespace luch::techniques::vista {
namespace {

constexpr std::array<std::string_view, 2> mode_words{"exact", "classic"};
constexpr std::array<std::string_view, 2> hidden_words{"painter", "depth"};
constexpr std::array<std::string_view, 3> repair_words{"none", "circumscribed", "both"};
constexpr std::array<double, 6> segment_counts{4, 8, 16, 32, 64, 128};

class Vista : public Technique {
 public:
    Vista(const Steps& steps, Mode mode) : buffer_(steps) { params_.mode = static_cast<int>(mode); }

    void visit(ParamVisitor& visitor) override {
        visitor.visit({"mode", "", "The baseline's picture, or the lecture's steps."}, params_.mode,
                      mode_words);
        visitor.visit(
            {"segments", "", "Segments around every sphere; 0: by its size on the screen."},
            params_.segments, 0, most_segments);
        visitor.visit({"hidden", "", "What decides which triangle is seen (classic)."},
                      params_.hidden, hidden_words);
        visitor.visit({"repair", "", "Which of its holes are closed (classic)."}, params_.repair,
                      repair_words);
    }

    [[nodiscard]] Plan plan(const Scene& scene, const Shot& shot) const override {
        return plan_of(scene, shot, params_);
    }

    void prepare(const Scene& scene, const Shot&, Context& context) override {
        if (Mode(params_.mode) == Mode::exact && context.plan().needed("item buffer")) {
            exact_.prepare(scene);
        }
    }

    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        const Needs needs = needs_of(context.plan());
        if (Mode(params_.mode) == Mode::classic) {
            render_classic(scene, shot, needs, frame, context);
        } else if (context.plan().needed("item buffer")) {
            render_exact(scene, shot, needs, frame, context);
        } else {
            return trace_frame(scene, shot, needs, context, frame.colour.view());
        }
        if (needs[Part::anti_aliasing] && may_antialias(shot)) {
            antialias(scene, shot, needs, context, frame.colour.view());
        }
    }

 private:
    void render_classic(const Scene& scene, const Shot& shot, const Needs& needs, Frame& frame,
                        Context& context) {
        if (hits_.size() != shot.size) hits_ = Image<Hit>(shot.size);
        const Screen screen(shot.camera, shot.size);
        buffer_.collect(scene, shot, params_, context);
        const auto farthest = static_cast<float>(buffer_.farthest_depth());
        auto& ids = frame.plane<NodeId>("ids", PlaneKind::id);
        auto& depth = frame.plane<float>("depth", PlaneKind::scalar, "units", 0, farthest);
        auto& fell_back = frame.plane<std::uint8_t>("fallbacks", PlaneKind::mask);
        buffer_.paint(screen, params_, context, ids.view(), depth.view());
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            Tracer& tracer = context.tracer(worker);
            tracer.counts().fallbacks += buffer_.look_up(screen, tile, worker, context, ids.view(),
                                                         hits_.view(), fell_back.view());
            shade_tile(scene, shot, tile, needs, tracer, hits_.view(), frame.colour.view());
        });
    }

    void render_exact(const Scene& scene, const Shot& shot, const Needs& needs, Frame& frame,
                      Context& context) {
        exact_.draw(shot, asked_segments(params_), context.plan().needed("stand-ins"), context);
        std::optional<ExactPlanes> planes;
        if (context.budget().planes) {
            planes = {frame.plane<NodeId>("ids", PlaneKind::id).view(),
                      frame.plane<std::uint32_t>("triangles", PlaneKind::id).view(),
                      frame.plane<std::uint8_t>("fallbacks", PlaneKind::mask).view(),
                      frame.plane<float>("lod", PlaneKind::scalar, "segments", 0, 64).view()};
        }
        std::atomic<std::uint64_t> searched = 0;
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            Tracer& tracer = context.tracer(worker);
            const std::uint64_t before = tracer.counts().fallbacks;
            RayPacket rays;
            HitPacket hits;
            exact_.look_up(tile, tracer, planes ? &*planes : nullptr, rays, hits);
            searched += tracer.counts().fallbacks - before;
            shade_tile(scene, shot, tile, needs, tracer, rays, hits, frame.colour.view());
        });
        context.did("item buffer", shot.size.area() - searched, "pixels");
        context.did("stand-ins", exact_.hulls().node_of.size(), "hulls");
    }

    Params params_;
    ClassicBuffer buffer_;
    ExactBuffer exact_;
    Image<Hit> hits_;
};

}  // namespace

Frustum frustum_of(const Screen& screen) {
    const double w = screen.half_width(), h = screen.half_height();
    return {{{{1, 0, w}, {-1, 0, w}, {0, 1, h}, {0, -1, h}}}};
}

double pixel_grid(Size size) {
    constexpr int bits = 26;
    const auto side = static_cast<unsigned>(std::max({size.width, size.height, 1}));
    return std::ldexp(1.0, static_cast<int>(std::bit_width(side - 1)) - bits);
}

int asked_segments(const Params& params) {
    return params.segments == 0 ? 0 : std::max(params.segments, least_segments);
}

std::unique_ptr<Technique> make(const Steps& steps, Mode mode) {
    return std::make_unique<Vista>(steps, mode);
}

const std::span<const double> segments_sweep{segment_counts};

TechniqueInfo describe() {
    return {.name = "vista",
            .title = "item buffer: primary hits without a search",
            .topic = "3. Vista buffer",
            .create = [] { return make(reference(), Mode::exact); },
            .sweep = {"segments", segments_sweep}};
}

}  // namespace luch::techniques::vista
