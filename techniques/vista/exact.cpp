#include "techniques/vista/exact.h"

#include "techniques/vista/vista.h"

#include <array>

namespace luch::techniques::vista {
namespace {

constexpr int capacity = RayPacket::capacity;
static_assert(ItemBuffer::tile_side == Context::tile_side);

/// No inverse depth of a front exceeds its ItemDepths::nearest by more: (1 + ρ) / (1 − ρ), ρ ≤
/// 1/16.
constexpr double front_spread = 1.14;
/// A hit's t is rounded to float, and its inverse depth reckoned from it.
constexpr double rounding = 1 - 0x1p-20;

/// The pixels of one tile while their hits are found.
class Tiling {
 public:
    Tiling(const Screen& screen, const ItemBuffer& meshes, int index, Tile tile, Tracer& tracer)
        : screen_(screen), tracer_(tracer), packet_(meshes.rays(index)) {
        const Tile whole = meshes.tile(index);
        for (int k = 0; k < capacity; ++k) {
            const int x = whole.x0 + ItemBuffer::x_in_tile(k);
            const int y = whole.y0 + ItemBuffer::y_in_tile(k);
            if (x < tile.x0 || x >= tile.x1 || y < tile.y0 || y >= tile.y1) continue;
            at_[static_cast<std::size_t>(count_)] = {k, x, y};
            ++count_;
        }
        HitPacket found;
        const bool some_ambiguous = meshes.resolve(index, packet_, found) > 0;
        for_each([&](std::size_t i) {
            rays_[i] = packet_.ray(at_[i].k);
            hits_[i] = found.hit(at_[i].k);
            tracer.counts().object_tests += hits_[i] ? 1 : 0;
            doubtful_[i] = some_ambiguous && meshes.ambiguous(index, at_[i].k);
        });
    }

    /// One node, in every pixel.
    void test(NodeId node) {
        for_each([&](std::size_t i) { nodes_[i] = doubtful_[i] ? no_node : node; });
        test_nodes();
    }

    /// The nodes whose hulls are in front.
    void test_fronts(const ItemBuffer& fronts, const Hulls& hulls, int index) {
        HitPacket front;
        const bool some_ambiguous = fronts.resolve(index, packet_, front) > 0;
        std::array<float, capacity> second{};
        bool any = false;
        for_each([&](std::size_t i) {
            nodes_[i] = no_node;
            if (some_ambiguous && fronts.ambiguous(index, at_[i].k)) doubtful_[i] = true;
            const NodeId hull = front.node[at_[i].k];
            if (doubtful_[i] || hull == no_node) return;
            const ItemDepths depths = fronts.depths(at_[i].x, at_[i].y);
            segments_[i] = hulls.segments[hull];
            if (inverse_depth(i) > front_spread * depths.nearest) return;
            nodes_[i] = hulls.node_of[hull];
            second[i] = depths.second;
            any = true;
        });
        if (!any) return;
        test_nodes();
        for_each([&](std::size_t i) {
            if (nodes_[i] != no_node && second[i] > 0) {
                doubtful_[i] = !(inverse_depth(i) * rounding > second[i]);
            }
        });
    }

    /// All that is in doubt.
    void trace() {
        std::vector<Ray> rays;
        for_each([&](std::size_t i) {
            if (doubtful_[i]) rays.push_back(rays_[i]);
        });
        if (rays.empty()) return;
        std::vector<Hit> hits(rays.size());
        tracer_.closest(RayKind::primary, rays, hits);
        tracer_.counts().fallbacks += rays.size();
        auto next = hits.begin();
        for_each([&](std::size_t i) {
            if (doubtful_[i]) hits_[i] = *next++;
        });
    }

    void write(const ExactPlanes& planes, const Scene& scene) {
        for_each([&](std::size_t i) {
            const auto [k, x, y] = at_[i];
            const Hit& hit = hits_[i];
            planes.hits(x, y) = hit;
            planes.ids(x, y) = hit.node;
            planes.fell_back(x, y) = doubtful_[i];
            planes.triangles(x, y) = hit && is_mesh(scene, hit.node) ? hit.primitive : no_node;
            planes.lod(x, y) = segments_[i];
        });
    }

    void record(RayLog& log) const {
        const auto count = static_cast<std::size_t>(count_);
        log.closest(RayKind::primary, {rays_.data(), count}, {hits_.data(), count});
    }

 private:
    struct Place {
        int k, x, y;
    };

    template <class Work>
    void for_each(Work&& work) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) work(i);
    }

    static bool is_mesh(const Scene& scene, NodeId node) {
        return std::holds_alternative<Mesh>(scene.geometries[scene.nodes[node].geometry]);
    }

    /// 0 where nothing was hit.
    [[nodiscard]] double inverse_depth(std::size_t i) const {
        if (!hits_[i]) return 0;
        return 1 / (double(hits_[i].t) * glm::dot(rays_[i].direction, screen_.forward()));
    }

    /// Keeps what is nearer than the hits so far.
    void test_nodes() {
        const auto count = static_cast<std::size_t>(count_);
        tracer_.test({nodes_.data(), count}, {rays_.data(), count}, {tested_.data(), count});
        for_each([&](std::size_t i) {
            if (tested_[i] && nearer(tested_[i], hits_[i])) hits_[i] = tested_[i];
        });
    }

    const Screen& screen_;
    Tracer& tracer_;
    RayPacket packet_;
    int count_ = 0;
    std::array<Place, capacity> at_;
    std::array<Ray, capacity> rays_;
    std::array<Hit, capacity> hits_, tested_;
    std::array<NodeId, capacity> nodes_;
    std::array<std::uint8_t, capacity> doubtful_{}, segments_{};
};

}  // namespace

void ExactBuffer::prepare(const Scene& scene) {
    scene_ = &scene;
    meshes_.emplace(scene, parsed_isa(""), ItemBuffer::Others::ignore);
}

void ExactBuffer::draw(const Shot& shot, int segments, bool stand_ins, Context& context) {
    screen_.emplace(shot.camera, shot.size);
    meshes_->draw(*screen_, Vec2d(0.5), context.pool());
    context.pause("item buffer");
    fronts_.reset();
    hulls_ = hulls_of(*scene_, *screen_, segments, stand_ins);
    if (!hulls_.scene.nodes.empty()) {
        fronts_.emplace(hulls_.scene);
        fronts_->draw(*screen_, Vec2d(0.5), context.pool(), true);
    }
    context.pause("stand-ins");
}

void ExactBuffer::look_up(Tile tile, Tracer& tracer, const ExactPlanes& planes) const {
    constexpr int side = ItemBuffer::tile_side;
    const int across = (screen_->size().width + side - 1) / side;
    const int index = tile.y0 / side * across + tile.x0 / side;
    // A watched pixel is one primary ray, however its hit is found.
    RayLog* const log = tracer.log();
    tracer.record(nullptr);
    Tiling pixels(*screen_, *meshes_, index, tile, tracer);
    for (const NodeId node : hulls_.boundless) pixels.test(node);
    if (fronts_) pixels.test_fronts(*fronts_, hulls_, index);
    pixels.trace();
    pixels.write(planes, *scene_);
    tracer.record(log);
    if (log != nullptr) pixels.record(*log);
}

}  // namespace luch::techniques::vista
