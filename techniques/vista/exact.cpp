#include "techniques/vista/exact.h"

#include "framework/baseline/classic.h"
#include "techniques/vista/vista.h"

#include <algorithm>
#include <array>

namespace luch::techniques::vista {
namespace {

static_assert(ItemBuffer::tile_side == Context::tile_side);

/// No inverse depth of a front exceeds its ItemDepths::nearest by more: (1 + ρ) / (1 − ρ), ρ ≤
/// 1/16.
constexpr double front_spread = 1.14;
/// A hit's t is rounded to float, and its inverse depth reckoned from it.
constexpr double rounding = 1 - 0x1p-20;

/// More nodes are not tested one by one in a pixel: a search is quicker.
constexpr std::size_t most_tests = 8;

/// The pixels of one tile while their hits are found, in the order of the framework's packets.
class Pixels {
 public:
    Pixels(const Screen& screen, const ItemBuffer& meshes, int index, Tile tile, Tracer& tracer,
           RayPacket& packet, HitPacket& found)
        : screen_(screen),
          tracer_(tracer),
          whole_(meshes.tile(index)),
          tile_(tile),
          packet_(packet),
          found_(found) {
        packet_ = meshes.rays(index);
        if (meshes.resolve(index, packet_, found_) == 0) return;
        meshes.show(index, items_);
        for_each([&](int k) { doubtful_[k] = items_.ambiguous[k]; });
    }

    /// One node, in every pixel.
    void test(NodeId node) { tracer_.test(node, packet_, found_); }

    /// The nodes whose hulls are in front; where that is not enough, all whose hulls may be there.
    void test_fronts(const ItemBuffer& fronts, const Hulls& hulls, int index) {
        fronts.show(index, items_);
        Asked in_front;
        for_each([&](int k) {
            const NodeId hull = items_.node[k];
            if (doubtful_[k] || hull == no_node) return;
            segments_[k] = hulls.segments[hull];
            if (inverse_depth(k) > front_spread * items_.depths[k].nearest) return;
            in_front.ask(k, hulls.node_of[hull]);
        });
        test(in_front);
        for_each([&](int k) {
            if (doubtful_[k]) return;
            if (items_.node[k] == no_node) {
                if (items_.ambiguous[k]) test_all(k, hulls);
                return;
            }
            const float second = items_.depths[k].second;
            if (in_front.node[k] == no_node || second == 0) return;
            if (!(inverse_depth(k) * rounding > second)) test_all(k, hulls);
        });
    }

    /// All that is in doubt.
    void trace() {
        if (std::find(doubtful_.begin(), doubtful_.end(), true) == doubtful_.end()) return;
        std::vector<Ray> rays;
        for_each([&](int k) {
            if (doubtful_[k]) rays.push_back(packet_.ray(k));
        });
        std::vector<Hit> hits(rays.size());
        tracer_.closest(RayKind::primary, rays, hits);
        tracer_.counts().fallbacks += rays.size();
        auto next = hits.begin();
        for_each([&](int k) {
            if (doubtful_[k]) found_.set(k, *next++);
        });
    }

    void write(const ExactPlanes& planes, const std::vector<bool>& is_mesh) const {
        put(found_.node, planes.ids);
        std::uint32_t triangles[RayPacket::capacity];
        for (int k = 0; k < RayPacket::capacity; ++k) {
            triangles[k] = found_.node[k] == no_node ? no_node : found_.primitive[k];
        }
        for (int k = 0; !is_mesh.empty() && k < RayPacket::capacity; ++k) {
            if (found_.node[k] != no_node && !is_mesh[found_.node[k]]) triangles[k] = no_node;
        }
        put(triangles, planes.triangles);
        put(doubtful_.data(), planes.fell_back);
        put(segments_.data(), planes.lod);
    }

    /// Leaves only the tile's own pixels in the packets.
    void compact() {
        if (is_whole()) return;
        const RayPacket rays = packet_;
        const HitPacket hits = found_;
        packet_.count = 0;
        for_each_pixel(tile_, [&](int x, int y) {
            const int k = entry_of(x - whole_.x0, y - whole_.y0);
            found_.set(packet_.count, hits.hit(k));
            packet_.add({rays.x[k], rays.y[k], rays.z[k]}, rays.t_max[k]);
        });
    }

    void record(RayLog& log) const {
        std::vector<Ray> rays;
        std::vector<Hit> hits;
        for_each([&](int k) {
            rays.push_back(packet_.ray(k));
            hits.push_back(found_.hit(k));
        });
        log.closest(RayKind::primary, rays, hits);
    }

 private:
    [[nodiscard]] int x_of(int k) const { return whole_.x0 + ItemBuffer::x_in_tile(k); }
    [[nodiscard]] int y_of(int k) const { return whole_.y0 + ItemBuffer::y_in_tile(k); }

    /// The inverse of x_in_tile() and y_in_tile().
    static int entry_of(int x, int y) { return y / 4 * 64 + x / 4 * 16 + y % 4 * 4 + x % 4; }

    /// Row by row; four neighbours at once where the tile is whole.
    template <class Value, class Pixel>
    void put(const Value* values, ImageView<Pixel> plane) const {
        if (!is_whole()) {
            for_each([&](int k) { plane(x_of(k), y_of(k)) = static_cast<Pixel>(values[k]); });
            return;
        }
        for (int y = 0; y < ItemBuffer::tile_side; ++y) {
            Pixel* const row = &plane(whole_.x0, whole_.y0 + y);
            for (int x = 0; x < ItemBuffer::tile_side; x += 4) {
                std::copy_n(values + entry_of(x, y), 4, row + x);
            }
        }
    }

    [[nodiscard]] bool is_whole() const { return tile_.area() == RayPacket::capacity; }

    template <class Work>
    void for_each(Work&& work) const {
        const bool all = is_whole();
        for (int k = 0; k < RayPacket::capacity; ++k) {
            if (all || inside(tile_, x_of(k), y_of(k))) work(k);
        }
    }

    static bool inside(const Tile& tile, int x, int y) {
        return x >= tile.x0 && x < tile.x1 && y >= tile.y0 && y < tile.y1;
    }

    /// Which node each pixel is to be tested with.
    struct Asked {
        std::array<NodeId, RayPacket::capacity> node;
        Asked() { node.fill(no_node); }
        void ask(int k, NodeId of) { node[static_cast<std::size_t>(k)] = of; }
    };

    /// One packet a node, in which only the pixels that ask for it look for something.
    void test(const Asked& asked) {
        const std::span<float> limits(packet_.t_max, RayPacket::capacity);
        std::array<float, RayPacket::capacity> before;
        std::ranges::copy(limits, before.begin());
        std::array<bool, RayPacket::capacity> done{};
        for (std::size_t first = 0; first < RayPacket::capacity; ++first) {
            const NodeId node = asked.node[first];
            if (node == no_node || done[first]) continue;
            for (std::size_t k = 0; k < RayPacket::capacity; ++k) {
                const bool asks = asked.node[k] == node;
                done[k] = done[k] || asks;
                limits[k] = asks ? before[k] : -std::numeric_limits<float>::infinity();
            }
            tracer_.test(node, packet_, found_);
        }
        std::ranges::copy(before, limits.begin());
    }

    /// Where the node in front was not enough: all whose hulls may be there, if they are few.
    void test_all(int k, const Hulls& hulls) {
        std::array<NodeId, most_tests> about;
        std::size_t count = 0;
        for (std::size_t hull = 0; hull < hulls.extents.size(); ++hull) {
            if (!inside(hulls.extents[hull], x_of(k), y_of(k))) continue;
            if (count == most_tests) {
                doubtful_[k] = true;
                return;
            }
            about[count++] = hulls.node_of[hull];
        }
        for (std::size_t i = 0; i < count; ++i) test(k, about[i]);
    }

    /// Keeps what is nearer than the hit so far.
    void test(int k, NodeId node) {
        const Ray ray = packet_.ray(k);
        Hit hit;
        tracer_.test({&node, 1}, {&ray, 1}, {&hit, 1});
        if (hit && nearer(hit, found_.hit(k))) found_.set(k, hit);
    }

    /// 0 where nothing was hit.
    [[nodiscard]] double inverse_depth(int k) const {
        if (found_.node[k] == no_node) return 0;
        const Vec3d direction(packet_.x[k], packet_.y[k], packet_.z[k]);
        return 1 / (double(found_.t[k]) * glm::dot(direction, screen_.forward()));
    }

    const Screen& screen_;
    Tracer& tracer_;
    Tile whole_, tile_;
    RayPacket& packet_;
    HitPacket& found_;
    ItemPacket items_;
    std::array<std::uint8_t, RayPacket::capacity> doubtful_{}, segments_{};
};

}  // namespace

void ExactBuffer::prepare(const Scene& scene) {
    scene_ = &scene;
    is_mesh_.clear();
    for (const Node& node : scene.nodes) {
        is_mesh_.push_back(std::holds_alternative<Mesh>(scene.geometries[node.geometry]));
    }
    if (std::find(is_mesh_.begin(), is_mesh_.end(), false) == is_mesh_.end()) is_mesh_.clear();
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

void ExactBuffer::look_up(Tile tile, Tracer& tracer, const ExactPlanes* planes, RayPacket& rays,
                          HitPacket& hits) const {
    constexpr int side = ItemBuffer::tile_side;
    const int across = (screen_->size().width + side - 1) / side;
    const int index = tile.y0 / side * across + tile.x0 / side;
    // A watched pixel is one primary ray, however its hit is found.
    RayLog* const log = tracer.log();
    tracer.record(nullptr);
    Pixels pixels(*screen_, *meshes_, index, tile, tracer, rays, hits);
    for (const NodeId node : hulls_.boundless) pixels.test(node);
    if (fronts_) pixels.test_fronts(*fronts_, hulls_, index);
    pixels.trace();
    if (planes != nullptr) pixels.write(*planes, is_mesh_);
    tracer.record(log);
    if (log != nullptr) pixels.record(*log);
    pixels.compact();
}

}  // namespace luch::techniques::vista
