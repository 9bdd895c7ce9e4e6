// The students' kit: what calls the steps, in the place of techniques/vista, which holds solutions.
// Where a step is not written there is no reference to stand in. On the public scenes, at their own
// camera and size, its stored output does; elsewhere the frame is hatched.
#include "framework/baseline/classic.h"
#include "homework/vista/check/samples.h"
#include "homework/vista/kit_frame.h"

#include <atomic>

namespace luch::techniques::vista {
namespace {

using homework::vista::LodSample;
using homework::vista::Sample;

constexpr std::array<std::string_view, 2> hidden_words{"painter", "depth"};
constexpr std::array<double, 6> segment_counts{4, 8, 16, 32, 64, 128};
constexpr int bin_side = 64;
constexpr std::size_t block = 4096;

/// Read once, when the first frame is prepared.
struct Files {
    std::vector<Sample> samples;
    LodSample lod;
};
const Files& files() {
    static const Files all{homework::vista::stored_samples(LUCH_SOURCE_DIR),
                           homework::vista::stored_lod(LUCH_SOURCE_DIR)};
    return all;
}

class Vista final : public Technique {
 public:
    explicit Vista(const Steps& steps) : steps_(steps) {}

    void visit(ParamVisitor& visitor) override {
        visitor.visit(
            {"segments", "", "Segments around every sphere; 0: by its size on the screen."},
            params_.segments, 0, most_segments);
        visitor.visit({"hidden", "", "What decides which triangle is seen."}, params_.hidden,
                      hidden_words);
    }

    [[nodiscard]] Plan plan(const Scene& scene, const Shot& shot) const override {
        if (shot.camera.projection != Projection::perspective || shot.camera.has_lens() ||
            shot.spp > 1) {
            return {false, "the buffer knows what one eye sees through the pixels' centres", {}};
        }
        return {true, "one object test a covered pixel instead of a search",
                classic_stages(scene, shot)};
    }

    void prepare(const Scene& scene, const Shot& shot, Context&) override {
        stored_ = nullptr;
        for (const Sample& sample : files().samples) {
            if (shows(sample, scene, shot)) stored_ = &sample;
        }
    }

    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        const Screen screen(shot.camera, shot.size);
        auto& ids = frame.plane<NodeId>("ids", PlaneKind::id);
        auto& depth = frame.plane<float>("depth", PlaneKind::scalar, "units", 0, 20);
        auto& fell_back = frame.plane<std::uint8_t>("fallbacks", PlaneKind::mask);
        std::fill(ids.pixels().begin(), ids.pixels().end(), no_node);
        const bool named = collect(scene, screen, context) && project(screen, context) &&
                           paint(context, ids.view(), depth.view());
        if (!named && !stored_ids(ids, depth)) {
            hatch(frame.colour.view().tile(), ids.view(), frame.colour.view());
            return;
        }
        if (hits_.size() != shot.size) hits_ = Image<Hit>(shot.size);
        const Needs needs = needs_of(context.plan());
        std::atomic<bool> whole = true;
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            Tracer& tracer = context.tracer(worker);
            if (!written(context, [&] {
                    steps_.look_up(screen, tile, ids.view(), tracer, hits_.view(),
                                   fell_back.view());
                })) {
                whole = false;
                return hatch(tile, ids.view(), frame.colour.view());
            }
            for (int y = tile.y0; y < tile.y1; ++y) {
                for (int x = tile.x0; x < tile.x1; ++x) {
                    tracer.counts().fallbacks += fell_back(x, y);
                }
            }
            shade_tile(scene, shot, tile, needs, tracer, hits_.view(), frame.colour.view());
        });
        if (whole && needs[Part::anti_aliasing] && may_antialias(shot)) {
            antialias(scene, shot, needs, context, frame.colour.view());
        }
    }

 private:
    /// lod and tessellate for one node, in view space. False: there is a hole.
    bool shape(const Scene& scene, NodeId id, const Screen& screen, Context& context,
               std::vector<Tri>& triangles) const {
        const Node& node = scene.nodes[id];
        const Geometry& geometry = scene.geometries[node.geometry];
        int n = asked_segments(params_);
        if (n == 0) {
            const float radius = radius_px(scene, node, screen);
            if (!written(context, [&] { n = steps_.lod(geometry, radius); })) {
                n = std::holds_alternative<Sphere>(geometry) ? stored_segments(files().lod, radius)
                                                             : 0;
            }
        }
        if (!written(context, [&] { steps_.tessellate(geometry, n, triangles); })) return false;
        drop_backs(geometry, node.to_object.point(screen.eye()), triangles);
        homework::vista::to_view(scene, id, screen, triangles);
        return true;
    }

    /// lod, tessellate, clip, sort. False: nobody knows which triangles are in view.
    bool collect(const Scene& scene, const Screen& screen, Context& context) {
        std::vector<std::vector<Tri>> of_node(scene.nodes.size());
        std::atomic<bool> shaped = true;
        context.for_each(static_cast<int>(scene.nodes.size()), [&](int i, int) {
            if (!shape(scene, static_cast<NodeId>(i), screen, context,
                       of_node[static_cast<std::size_t>(i)])) {
                shaped = false;
            }
        });
        std::vector<Tri> around;
        for (const auto& some : of_node) around.insert(around.end(), some.begin(), some.end());
        if (!shaped && stored_ != nullptr) around = stored_->around;
        bool known = shaped || stored_ != nullptr;
        if (!written(context, [&] { steps_.clip(around, frustum_of(screen), triangles_); })) {
            known = stored_ != nullptr;
            if (known) triangles_ = stored_->in_view;
        }
        if (Hidden(params_.hidden) == Hidden::depth) return known;
        if (!written(context, [&] { steps_.sort(triangles_); })) {
            known = stored_ != nullptr;
            if (known) triangles_ = stored_->sorted();
        }
        return known;
    }

    bool project(const Screen& screen, Context& context) {
        on_screen_.assign(triangles_.size(), {});
        std::atomic<bool> projected = true;
        const std::size_t blocks = (triangles_.size() + block - 1) / block;
        context.for_each(static_cast<int>(blocks), [&](int i, int) {
            const std::size_t first = static_cast<std::size_t>(i) * block;
            const std::size_t count = std::min(block, triangles_.size() - first);
            if (!written(context, [&] {
                    steps_.project(std::span(triangles_).subspan(first, count), screen,
                                   std::span(on_screen_).subspan(first, count));
                })) {
                projected = false;
            }
        });
        if (!projected && stored_ != nullptr) on_screen_ = stored_->on_screen;
        return projected || stored_ != nullptr;
    }

    bool paint(Context& context, ImageView<NodeId> ids, ImageView<float> depth) const {
        std::atomic<bool> painted = true;
        context.for_each_tile(
            ids.size(),
            [&](Tile tile, int) {
                std::vector<ScreenTri> near;
                std::copy_if(on_screen_.begin(), on_screen_.end(), std::back_inserter(near),
                             [&](const ScreenTri& triangle) { return touches(triangle, tile); });
                if (!written(context, [&] {
                        steps_.rasterise(near, tile, Hidden(params_.hidden), ids, depth);
                    })) {
                    painted = false;
                }
            },
            bin_side);
        return painted;
    }

    bool stored_ids(Image<NodeId>& ids, Image<float>& depth) const {
        if (stored_ == nullptr) return false;
        ids = Hidden(params_.hidden) == Hidden::depth ? stored_->nearest_ids : stored_->painter_ids;
        depth = stored_->nearest_depth;
        return true;
    }

    Steps steps_;
    Params params_;
    const Sample* stored_ = nullptr;  ///< of a public scene, seen as it was stored
    std::vector<Tri> triangles_;
    std::vector<ScreenTri> on_screen_;
    Image<Hit> hits_;
};

}  // namespace

int asked_segments(const Params& params) {
    return params.segments == 0 ? 0 : std::max(params.segments, least_segments);
}

std::unique_ptr<Technique> make(const Steps& steps, Mode) {
    return std::make_unique<Vista>(steps);
}

const std::span<const double> segments_sweep{segment_counts};

}  // namespace luch::techniques::vista
