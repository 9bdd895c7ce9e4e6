#include "techniques/layered/fragments.h"

#include "framework/baseline/classic.h"
#include "techniques/layered/peel.h"

#include <limits>
#include <numbers>

namespace luch::techniques::layered {
namespace {

static_assert(ItemBuffer::tile_side == Context::tile_side);

void trace(const Screen& screen, Tile tile, Tracer& tracer, ImageView<Hit> hits) {
    constexpr int block = 4;
    std::vector<Ray> rays;
    std::vector<Hit*> targets;
    for (int y0 = tile.y0; y0 < tile.y1; y0 += block) {
        for (int x0 = tile.x0; x0 < tile.x1; x0 += block) {
            for (int y = y0; y < std::min(y0 + block, tile.y1); ++y) {
                for (int x = x0; x < std::min(x0 + block, tile.x1); ++x) {
                    rays.push_back(screen.ray(x + 0.5, y + 0.5));
                    targets.push_back(&hits(x, y));
                }
            }
        }
    }
    std::vector<Hit> found(rays.size());
    tracer.closest(RayKind::primary, rays, found);
    for (std::size_t i = 0; i < found.size(); ++i) *targets[i] = found[i];
}

/// From the item buffer's frame; what is in doubt there is traced.
void resolve(const ItemBuffer& buffer, int index, Tracer& tracer, ImageView<Hit> hits) {
    const Tile tile = buffer.tile(index);
    const RayPacket packet = buffer.rays(index);
    HitPacket found;
    ItemPacket items;
    const bool doubts = buffer.resolve(index, packet, found) > 0;
    if (doubts) buffer.show(index, items);
    std::vector<Ray> rays;
    std::vector<Hit*> targets;
    for (int k = 0; k < RayPacket::capacity; ++k) {
        const int x = tile.x0 + ItemBuffer::x_in_tile(k), y = tile.y0 + ItemBuffer::y_in_tile(k);
        if (x >= tile.x1 || y >= tile.y1) continue;
        hits(x, y) = found.hit(k);
        if (!doubts || !items.ambiguous[k]) continue;
        rays.push_back(packet.ray(k));
        targets.push_back(&hits(x, y));
    }
    if (rays.empty()) return;
    std::vector<Hit> traced(rays.size());
    tracer.closest(RayKind::primary, rays, traced);
    tracer.counts().fallbacks += rays.size();
    for (std::size_t i = 0; i < traced.size(); ++i) *targets[i] = traced[i];
}

float depth_of(const Screen& screen, int x, int y, const Hit& hit) {
    if (!hit) return std::numeric_limits<float>::infinity();
    const Ray ray = screen.ray(x + 0.5, y + 0.5);
    return static_cast<float>(hit.t * glm::dot(ray.direction, screen.forward()));
}

}  // namespace

int detail_for(Size frame, int asked) {
    constexpr int longest_side = 16384;
    const int side = std::max({frame.width, frame.height, 1});
    return std::clamp(longest_side / (side + side / 4), 1, asked);
}

int margin_for(const Shot& shot, Tracer& tracer) {
    constexpr int step = 8;
    Camera sharp = shot.camera;
    sharp.depth_of_field = false;
    const Screen screen(sharp, shot.size);
    const int width = shot.size.width, height = shot.size.height;
    std::vector<Ray> rays;
    for (int x = 0; x <= width; x += step) {
        for (const int y : {0, height}) rays.push_back(screen.ray(x, y));
    }
    for (int y = 0; y <= height; y += step) {
        for (const int x : {0, width}) rays.push_back(screen.ray(x, y));
    }
    std::vector<Hit> hits(rays.size());
    tracer.closest(RayKind::primary, rays, hits);
    const Lens lens = lens_of(shot.camera, shot.size);
    double widest = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i]) continue;
        const double depth = hits[i].t * glm::dot(rays[i].direction, screen.forward());
        widest = std::max(widest, std::abs(signed_radius_px(depth, lens)));
    }
    // Wider margins cost more than the blurred rim of the picture is worth.
    const int most = std::min(width, height) / 8;
    return std::min(static_cast<int>(std::ceil(widest)), most);
}

Camera padded(const Camera& camera, Size size, int margin_px) {
    Camera sharp = camera;
    sharp.depth_of_field = false;
    if (margin_px == 0) return sharp;
    const Screen screen(camera, size);
    const double half_width = screen.half_width() * (size.width + 2 * margin_px) / size.width;
    const double half_height = screen.half_height() * (size.height + 2 * margin_px) / size.height;
    sharp.aspect = half_width / half_height;
    sharp.fov_deg = std::atan(std::hypot(half_width, half_height)) * 360 / std::numbers::pi;
    return sharp;
}

void Fragments::prepare(const Scene& scene, bool raster) {
    scene_ = &scene;
    if (raster) buffer_.emplace(scene);
}

void Fragments::look(const Shot& shot, const Wish& wish, const Needs& needs, Context& context) {
    wish_ = wish;
    Shot fine = shot;
    fine.camera = padded(shot.camera, shot.size, wish.margin_px);
    fine.size = {(shot.size.width + 2 * wish.margin_px) * wish.detail,
                 (shot.size.height + 2 * wish.margin_px) * wish.detail};
    fine.spp = 1;
    if (colour_.size() != fine.size) {
        hits_ = Image<Hit>(fine.size);
        colour_ = Image<Rgb>(fine.size);
        depth_ = Image<float>(fine.size);
        first_ = Image<std::uint32_t>(fine.size);
    }
    see_front(fine, needs, context);
    see_behind(fine, lens_of(shot.camera, shot.size), needs, context);
}

void Fragments::see_front(const Shot& fine, const Needs& needs, Context& context) {
    const Screen screen(fine.camera, fine.size);
    const bool raster = wish_.raster && buffer_ && ItemBuffer::applies(fine.camera, fine.size);
    if (raster) buffer_->draw(screen, Vec2d(0.5), context.pool());
    const int across = (fine.size.width + Context::tile_side - 1) / Context::tile_side;
    context.for_each_tile(fine.size, [&](Tile tile, int worker) {
        Tracer& tracer = context.tracer(worker);
        const int index = tile.y0 / Context::tile_side * across + tile.x0 / Context::tile_side;
        if (raster) {
            resolve(*buffer_, index, tracer, hits_.view());
        } else {
            trace(screen, tile, tracer, hits_.view());
        }
        shade_tile(*scene_, fine, tile, needs, tracer, hits_.view(), colour_.view());
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                depth_(x, y) = depth_of(screen, x, y, hits_(x, y));
            }
        }
    });
}

void Fragments::see_behind(const Shot& fine, const Lens& lens, const Needs& needs,
                           Context& context) {
    const Openings openings(depth_.view(), lens, wish_.detail);
    std::vector<Peeled> tiles(
        static_cast<std::size_t>((fine.size.width + Context::tile_side - 1) / Context::tile_side) *
        static_cast<std::size_t>((fine.size.height + Context::tile_side - 1) / Context::tile_side));
    const int across = (fine.size.width + Context::tile_side - 1) / Context::tile_side;
    context.for_each_tile(fine.size, [&](Tile tile, int worker) {
        const Peeler peeler(*scene_, fine, lens, needs, context.tracer(worker));
        Peeled& found = tiles[static_cast<std::size_t>(tile.y0 / Context::tile_side * across +
                                                       tile.x0 / Context::tile_side)];
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                first_(x, y) = none;
                if (wish_.behind > 0) {
                    if (depth_(x, y) < wish_.behind) peeler.beyond(x, y, wish_.behind, found);
                    continue;
                }
                const auto deepest = wish_.edges ? openings.farthest(x, y) : std::nullopt;
                if (deepest) peeler.peel(x, y, hits_(x, y), *deepest, found);
            }
        }
        peeler.shade(found);
    });
    hidden_.clear();
    for (const Peeled& tile : tiles) {
        for (std::size_t i = 0; i < tile.hidden.size(); ++i) {
            const auto [x, y] = tile.texels[i];
            if (first_(x, y) == none) first_(x, y) = static_cast<std::uint32_t>(hidden_.size());
            hidden_.push_back(tile.hidden[i]);
        }
    }
}

}  // namespace luch::techniques::layered
