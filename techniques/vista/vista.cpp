#include "techniques/vista/vista.h"

#include "framework/baseline/classic.h"
#include "framework/technique/catalogue.h"
#include "techniques/vista/buffer.h"
#include "techniques/vista/plan.h"

#include <bit>

namespace luch::techniques::vista {
namespace {

constexpr std::array<std::string_view, 2> hidden_words{"painter", "depth"};
constexpr std::array<double, 6> segment_counts{4, 8, 16, 32, 64, 128};

class Vista : public Technique {
 public:
    explicit Vista(const Steps& steps) : buffer_(steps) {}

    void visit(ParamVisitor& visitor) override {
        visitor.visit(
            {"segments", "", "Segments around every sphere; 0: by its size on the screen."},
            params_.segments, 0, most_segments);
        visitor.visit({"hidden", "", "What decides which triangle is seen."}, params_.hidden,
                      hidden_words);
    }

    [[nodiscard]] Plan plan(const Scene& scene, const Shot& shot) const override {
        return plan_of(scene, shot, params_);
    }

    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        const Screen screen(shot.camera, shot.size);
        buffer_.collect(scene, shot, params_, context);
        const auto farthest = static_cast<float>(buffer_.farthest_depth());
        auto& ids = frame.plane<NodeId>("ids", PlaneKind::id);
        auto& depth = frame.plane<float>("depth", PlaneKind::scalar, "units", 0, farthest);
        auto& fell_back = frame.plane<std::uint8_t>("fallbacks", PlaneKind::mask);
        buffer_.paint(screen, params_, context, ids.view(), depth.view());
        if (hits_.size() != shot.size) hits_ = Image<Hit>(shot.size);
        const Needs needs = needs_of(context.plan());
        const auto colour = frame.colour.view();
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            Tracer& tracer = context.tracer(worker);
            tracer.counts().fallbacks += buffer_.look_up(screen, tile, worker, context, ids.view(),
                                                         hits_.view(), fell_back.view());
            shade_tile(scene, shot, tile, needs, tracer, hits_.view(), colour);
        });
        if (needs[Part::anti_aliasing] && may_antialias(shot)) {
            antialias(scene, shot, needs, context, colour);
        }
    }

 private:
    Params params_;
    ItemBuffer buffer_;
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

std::unique_ptr<Technique> make(const Steps& steps) {
    return std::make_unique<Vista>(steps);
}

const std::span<const double> segments_sweep{segment_counts};

TechniqueInfo describe() {
    return {.name = "vista",
            .title = "item buffer: node ids, not a search",
            .topic = "3. Vista buffer",
            .create = [] { return make(reference()); },
            .sweep = {"segments", segments_sweep}};
}

}  // namespace luch::techniques::vista
