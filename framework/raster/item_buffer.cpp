#include "framework/raster/item_buffer.h"

#include "framework/accel/node_hit.h"
#include "framework/raster/frame.h"
#include "framework/raster/kernels.h"

#include <algorithm>
#include <cassert>
#include <optional>

namespace luch {
namespace {

using namespace raster;

constexpr float infinite = std::numeric_limits<float>::infinity();

const Kernels& kernels_of(Isa isa) {
#if defined(LUCH_X86_64_LEVELS)
    if (isa == Isa::v2) return kernels_v2();
    if (isa == Isa::v3) return kernels_v3();
    if (isa == Isa::v4) return kernels_v4();
#endif
    static_cast<void>(isa);
    return kernels_plain();
}

/// Asks for the 256 items of a tile, which is soon to be resolved.
void fetch(const std::uint32_t* items) {
#if defined(__GNUC__)
    constexpr int of_line = 16;
    for (int i = 0; i < RayPacket::capacity; i += of_line) __builtin_prefetch(items + i);
#else
    static_cast<void>(items);
#endif
}

}  // namespace

struct ItemBuffer::State {
    const Scene* scene;
    const Kernels* kernels;
    Stock stock;
    Frame frame;
    std::optional<Screen> screen;
    Vec2d offset{0};

    /// The bits of pixel (x, y).
    [[nodiscard]] std::size_t at(int x, int y) const {
        const int cell = (y / 4 % 4) * 4 + x / 4 % 4, pixel = (y % 4) * 4 + x % 4;
        return static_cast<std::size_t>(frame.tile_at(x / 16, y / 16)) * 256 +
               static_cast<std::size_t>(cell * 16 + pixel);
    }
    [[nodiscard]] int tiles_across() const {
        return (screen->size().width + tile_side - 1) / tile_side;
    }
    [[nodiscard]] std::size_t items_of(int tile) const {
        return static_cast<std::size_t>(
                   frame.tile_at(tile % tiles_across(), tile / tiles_across())) *
               256;
    }
};

ItemBuffer::ItemBuffer(const Scene& scene, Isa isa, Others others)
    : state_(new State{
          &scene, &kernels_of(isa), stock_of(scene, others == Others::mark), {}, {}, {}}) {}
ItemBuffer::~ItemBuffer() = default;
ItemBuffer::ItemBuffer(ItemBuffer&&) noexcept = default;

bool ItemBuffer::applies(const Camera& camera, Size size) {
    return camera.projection == Projection::perspective && !camera.has_lens() &&
           std::max(size.width, size.height) <= 16384;
}

void ItemBuffer::draw(const Screen& screen, const Vec2d& offset, const Workers& workers,
                      bool with_depths) {
    assert(screen.projection() == Projection::perspective);
    state_->screen = screen;
    state_->offset = offset;
    const Sight sight{&screen, offset};
    state_->frame.draw(*state_->scene, state_->stock, *state_->kernels, sight, workers,
                       with_depths);
}

Size ItemBuffer::size() const {
    return state_->screen ? state_->screen->size() : Size{};
}

Item ItemBuffer::item(int x, int y) const {
    const std::uint32_t item = state_->frame.items[state_->at(x, y)];
    if ((item & ambiguous_bit) != 0) return {.ambiguous = true};
    if (item == no_item) return {};
    const Stock::Model& model = state_->stock.model_of(item);
    return {model.node, model.soup->triangles[item - model.base].id, false};
}

ItemDepths ItemBuffer::depths(int x, int y) const {
    if (state_->frame.near.empty()) return {};
    const std::size_t i = state_->at(x, y);
    return {state_->frame.near[i], state_->frame.second[i]};
}

std::uint64_t ItemBuffer::ambiguous_count() const {
    std::uint64_t count = 0;
    for (int y = 0; y < size().height; ++y) {
        for (int x = 0; x < size().width; ++x) {
            count += state_->frame.items[state_->at(x, y)] >> 31;
        }
    }
    return count;
}

int ItemBuffer::tile_count() const {
    return state_->screen ? state_->tiles_across() * ((size().height + tile_side - 1) / tile_side)
                          : 0;
}

Tile ItemBuffer::tile(int i) const {
    const int x = i % state_->tiles_across() * tile_side,
              y = i / state_->tiles_across() * tile_side;
    return {x, y, std::min(x + tile_side, size().width), std::min(y + tile_side, size().height)};
}

RayPacket ItemBuffer::rays(int index) const {
    const Tile at = tile(index);
    const Screen& screen = *state_->screen;
    double column[tile_side], row[tile_side];
    for (int i = 0; i < tile_side; ++i) {
        column[i] = screen.across(at.x0 + i + state_->offset.x);
        row[i] = screen.upwards(at.y0 + i + state_->offset.y);
    }
    double sx[RayPacket::capacity], sy[RayPacket::capacity];
    RayPacket rays;
    for (int k = 0; k < RayPacket::capacity; k += 4) {
        const int x = x_in_tile(k), y = y_in_tile(k);
        for (int i = 0; i < 4; ++i) {
            sx[k + i] = column[x + i];
            sy[k + i] = row[y];
            rays.t_max[k + i] = x + i < at.width() && y < at.height() ? infinite : -infinite;
        }
    }
    rays.origin = screen.eye();
    rays.count = RayPacket::capacity;
    screen.directions(sx, sy, rays.x, rays.y, rays.z);
    return rays;
}

int ItemBuffer::resolve(int tile, const RayPacket& rays, HitPacket& hits) const {
    const std::uint32_t* items = state_->frame.items.data() + state_->items_of(tile);
    if (tile + 1 < tile_count()) fetch(state_->frame.items.data() + state_->items_of(tile + 1));
    const Kernels& kernels = *state_->kernels;
    const Survey all = kernels.survey(items);
    if (all.lowest == no_item) {
        kernels.miss(hits);
        return all.ambiguous;
    }
    const Stock& stock = state_->stock;
    const Stock::Model* first = &stock.model_of(all.lowest);
    const Stock::Model* end = stock.models.data() + stock.models.size();
    for (const Stock::Model* model = first; model != end && model->base <= all.highest; ++model) {
        const Target target{model->soup->triangles.data(),
                            model->base,
                            static_cast<std::uint32_t>(model->soup->triangles.size()),
                            model->node,
                            &state_->scene->nodes[model->node].to_object,
                            model->soup->cull_backfaces};
        kernels.resolve(target, items, rays, model == first, hits);
    }
    return all.ambiguous;
}

void ItemBuffer::show(int tile, ItemPacket& packet) const {
    const std::size_t first = state_->items_of(tile);
    const raster::Frame& frame = state_->frame;
    std::uint32_t base = 0, count = 0;  // of the model that was seen last
    NodeId node = no_node;
    for (std::size_t k = 0; k < RayPacket::capacity; ++k) {
        const std::uint32_t item = frame.items[first + k];
        packet.ambiguous[k] = (item & ambiguous_bit) != 0;
        packet.depths[k] = frame.near.empty()
                               ? ItemDepths{}
                               : ItemDepths{frame.near[first + k], frame.second[first + k]};
        packet.node[k] = no_node;
        if (item >= no_item) continue;
        if (item - base >= count) {
            const Stock::Model& model = state_->stock.model_of(item);
            base = model.base;
            count = static_cast<std::uint32_t>(model.soup->triangles.size());
            node = model.node;
        }
        packet.node[k] = node;
    }
}

void ItemBuffer::trace_ambiguous(int tile, const RayPacket& rays, const Accelerator& accelerator,
                                 HitPacket& hits, WorkCounts& work) const {
    const std::uint32_t* items = state_->frame.items.data() + state_->items_of(tile);
    for (int i = 0; i < rays.count; ++i) {
        if ((items[i] & ambiguous_bit) == 0) continue;
        if (!(rays.t_max[i] > rays.t_min)) continue;
        hits.set(i, accelerator.closest(rays.ray(i), work));
    }
}

std::uint64_t ItemBuffer::bytes() const {
    return state_->stock.bytes() + state_->frame.bytes();
}

}  // namespace luch
