#include "techniques/layered/fragments.h"

#include "framework/technique/samples.h"
#include "techniques/layered/peel.h"

#include <atomic>
#include <limits>
#include <numbers>

namespace luch::techniques::layered {
namespace {

/// What a texel's key is used for: as the baseline's.
constexpr std::uint64_t radiance = 1;

static_assert(ItemBuffer::tile_side == Context::tile_side);

/// In blocks of neighbours, as packets like them.
template <class Work>
void for_each_pixel(const Tile& tile, Work&& work) {
    constexpr int block = 4;
    for (int y0 = tile.y0; y0 < tile.y1; y0 += block) {
        for (int x0 = tile.x0; x0 < tile.x1; x0 += block) {
            for (int y = y0; y < std::min(y0 + block, tile.y1); ++y) {
                for (int x = x0; x < std::min(x0 + block, tile.x1); ++x) work(x, y);
            }
        }
    }
}

/// One of a pixel's texels, in another place in each of four neighbours.
int one_of(int x, int y, int texels) {
    return (x + 2 * y) % 4 * texels / 4;
}

/// Texels that are lit together.
struct Texels {
    std::vector<std::pair<int, int>> places;
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::vector<Key> keys;

    void add(const Shot& fine, const Screen& screen, int x, int y, const Hit& hit) {
        places.emplace_back(x, y);
        rays.push_back(screen.ray(x + 0.5, y + 0.5));
        hits.push_back(hit);
        keys.push_back(sample_key(fine, x, y, 0).branch(radiance));
    }
    void light(const Whitted& whitted, ImageView<Rgb> colour) const {
        std::vector<Rgb> light(rays.size());
        whitted.shade(RayKind::primary, rays, hits, keys, light);
        for (std::size_t i = 0; i < light.size(); ++i) {
            colour(places[i].first, places[i].second) = light[i];
        }
    }
};

void trace(const Screen& screen, Tile tile, Tracer& tracer, ImageView<Hit> hits) {
    std::vector<Ray> rays;
    std::vector<Hit*> targets;
    for_each_pixel(tile, [&](int x, int y) {
        rays.push_back(screen.ray(x + 0.5, y + 0.5));
        targets.push_back(&hits(x, y));
    });
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
    const int most = std::min(width, height) / 24;
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
    if (colour_.size() != fine.size || first_.width() * wish.detail != fine.size.width) {
        hits_ = Image<Hit>(fine.size);
        colour_ = Image<Rgb>(fine.size);
        depth_ = Image<float>(fine.size);
        first_ =
            Image<std::uint32_t>({fine.size.width / wish.detail, fine.size.height / wish.detail});
    }
    const Lens lens = lens_of(shot.camera, shot.size);
    see_front(fine, context);
    light_front(fine, lens, needs, context);
    see_behind(fine, lens, needs, context);
}

void Fragments::see_front(const Shot& fine, Context& context) {
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
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                depth_(x, y) = depth_of(screen, x, y, hits_(x, y));
            }
        }
    });
}

bool Fragments::is_lit_once(int x, int y, const Lens& lens) const {
    const int d = wish_.detail;
    for (int k = 0; k < d * d; ++k) {
        const int i = x * d + k % d, j = y * d + k / d;
        if (hits_(i, j).node != hits_(x * d, y * d).node) return false;
        const double diameter = 2 * std::abs(signed_radius_px(depth_(i, j), lens));
        if (!(diameter > wish_.lit_once_px)) return false;
    }
    return true;
}

void Fragments::light_front(const Shot& fine, const Lens& lens, const Needs& needs,
                            Context& context) {
    const Screen screen(fine.camera, fine.size);
    std::atomic<std::uint64_t> lit = 0;
    const int side = std::max(Context::tile_side / wish_.detail, 1);
    context.for_each_tile(
        first_.size(),
        [&](Tile pixels, int worker) {
            Texels texels;
            for_each_pixel(pixels, [&](int x, int y) {
                const int d = wish_.detail;
                const bool once = is_lit_once(x, y, lens);
                for (int k = 0; k < d * d; ++k) {
                    if (once && k != one_of(x, y, d * d)) continue;
                    const int i = x * d + k % d, j = y * d + k / d;
                    texels.add(fine, screen, i, j, hits_(i, j));
                }
            });
            lit += texels.rays.size();
            texels.light(Whitted(*scene_, needs, context.tracer(worker)), colour_.view());
            for_each_pixel(pixels, [&](int x, int y) {
                if (!is_lit_once(x, y, lens)) return;
                const int d = wish_.detail, one = one_of(x, y, d * d);
                const Rgb colour = colour_(x * d + one % d, y * d + one / d);
                for (int k = 0; k < d * d; ++k) {
                    colour_(x * d + k % d, y * d + k / d) = colour;
                }
            });
        },
        side);
    lit_ = lit;
}

void Fragments::see_behind(Tile pixels, const Openings& openings, const Peeler& peeler,
                           Peeled& found) {
    for (int y = pixels.y0; y < pixels.y1; ++y) {
        for (int x = pixels.x0; x < pixels.x1; ++x) {
            first_(x, y) = none;
            // The pixel's nearest texel hides most.
            const int d = wish_.detail;
            int i = x * d, j = y * d;
            for (int k = 0; k < d * d; ++k) {
                const int other_i = x * d + k % d, other_j = y * d + k / d;
                if (depth_(other_i, other_j) < depth_(i, j)) i = other_i, j = other_j;
            }
            if (wish_.behind > 0) {
                if (depth_(i, j) < wish_.behind) peeler.beyond(i, j, wish_.behind, found);
            } else if (wish_.edges) {
                const std::optional<double> deepest = openings.farthest(i, j);
                if (deepest) peeler.peel(i, j, hits_(i, j), *deepest, found);
            }
        }
    }
    peeler.shade(found);
}

void Fragments::see_behind(const Shot& fine, const Lens& lens, const Needs& needs,
                           Context& context) {
    const Openings openings(depth_.view(), lens, wish_.detail);
    const int across = (first_.width() + Context::tile_side - 1) / Context::tile_side;
    const int down = (first_.height() + Context::tile_side - 1) / Context::tile_side;
    std::vector<Peeled> tiles(Size{across, down}.area());
    context.for_each_tile(first_.size(), [&](Tile tile, int worker) {
        const int index = tile.y0 / Context::tile_side * across + tile.x0 / Context::tile_side;
        see_behind(tile, openings, Peeler(*scene_, fine, lens, needs, context.tracer(worker)),
                   tiles[static_cast<std::size_t>(index)]);
    });
    hidden_.clear();
    for (const Peeled& tile : tiles) {
        for (std::size_t i = 0; i < tile.hidden.size(); ++i) {
            const auto [x, y] = tile.texels[i];
            std::uint32_t& first = first_(x / wish_.detail, y / wish_.detail);
            if (first == none) first = static_cast<std::uint32_t>(hidden_.size());
            hidden_.push_back(tile.hidden[i]);
        }
    }
}

}  // namespace luch::techniques::layered
