#include "framework/baseline/classic.h"

#include <limits>

namespace luch {
namespace {

/// What a sample's key is used for.
constexpr std::uint64_t radiance = 1;

/// The rays of a tile's pixels, but for pixels that no ray goes through.
struct TileRays {
    std::vector<std::pair<int, int>> pixels;
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::vector<Key> keys;
    std::vector<Rgb> light;

    void clear() {
        pixels.clear();
        rays.clear();
        hits.clear();
        keys.clear();
    }
    void add(int x, int y, const Ray& ray, Key key) {
        if (nowhere(ray)) return;
        pixels.emplace_back(x, y);
        rays.push_back(ray);
        keys.push_back(key.branch(radiance));
    }
    /// A whole tile.
    void add(const Shot& shot, const Tile& tile, int sample, const RayPacket& packet,
             const HitPacket& found) {
        int i = 0;
        for_each_pixel(tile, [&](int x, int y) {
            pixels.emplace_back(x, y);
            rays.push_back(packet.ray(i));
            hits.push_back(found.hit(i++));
            keys.push_back(sample_key(shot, x, y, sample).branch(radiance));
        });
    }
    /// Adds what the rays bring, their hits being known.
    void shade(const Whitted& whitted, ImageView<Rgb> colour) {
        light.resize(rays.size());
        whitted.shade(RayKind::primary, rays, hits, keys, light);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            colour(pixels[i].first, pixels[i].second) += light[i];
        }
    }
};

/// Where a sample lies in each of a tile's pixels, as Screen::directions() wants it. Returns how
/// many there are.
std::size_t points_of(const Screen& screen, const Shot& shot, const Tile& tile, int sample,
                      int samples, double* sx, double* sy) {
    std::size_t count = 0;
    if (samples > 1) {
        for_each_pixel(tile, [&](int x, int y) {
            const Vec2d at = sample_position(shot, x, y, sample, samples);
            sx[count] = screen.across(at.x);
            sy[count++] = screen.upwards(at.y);
        });
        return count;
    }
    std::array<double, RayPacket::capacity> column, row;  // the centres are those of all others
    for (int i = 0; i < tile.width(); ++i) {
        column[static_cast<std::size_t>(i)] = screen.across(tile.x0 + i + 0.5);
    }
    for (int i = 0; i < tile.height(); ++i) {
        row[static_cast<std::size_t>(i)] = screen.upwards(tile.y0 + i + 0.5);
    }
    for_each_pixel(tile, [&](int x, int y) {
        sx[count] = column[static_cast<std::size_t>(x - tile.x0)];
        sy[count++] = row[static_cast<std::size_t>(y - tile.y0)];
    });
    return count;
}

/// The rays of a tile's pixels in a packet, for cameras that have one eye and see everywhere.
void aim(const Screen& screen, const Shot& shot, const Tile& tile, int sample, int samples,
         RayPacket& rays) {
    double sx[RayPacket::capacity], sy[RayPacket::capacity];
    const std::size_t count = points_of(screen, shot, tile, sample, samples, sx, sy);
    rays.origin = screen.eye();
    rays.count = static_cast<int>(count);
    std::fill_n(rays.t_max, count, std::numeric_limits<float>::infinity());
    screen.directions({sx, count}, {sy, count}, rays.x, rays.y, rays.z);
}

/// Whether aim() does for such a tile and camera.
bool goes_in_a_packet(const Screen& screen, const Tile& tile, bool lens) {
    return screen.projection() == Projection::perspective && !lens &&
           tile.area() <= std::size_t{RayPacket::capacity};
}

/// Whether a pixel stands out from its four neighbours, or one of them does.
bool is_edge(ImageView<const Rgb> image, int x, int y) {
    const auto clamped = [&](int i, int j) {
        return glm::min(
            image(std::clamp(i, 0, image.width() - 1), std::clamp(j, 0, image.height() - 1)),
            Rgb(1));
    };
    const std::array cross{clamped(x, y), clamped(x - 1, y), clamped(x + 1, y), clamped(x, y - 1),
                           clamped(x, y + 1)};
    const Rgb mean = (cross[0] + cross[1] + cross[2] + cross[3] + cross[4]) / 5.0f;
    constexpr float threshold = 0.1f;
    return std::any_of(cross.begin(), cross.end(),
                       [&](const Rgb& colour) { return max_norm(colour - mean) > threshold; });
}

}  // namespace

Key radiance_key(const Shot& shot, int x, int y, int sample) {
    return sample_key(shot, x, y, sample).branch(radiance);
}

void trace_tile(const Scene& scene, const Shot& shot, const Tile& tile, const Needs& needs,
                Tracer& tracer, ImageView<Rgb> colour) {
    const Screen screen(shot.camera, shot.size);
    const Whitted whitted(scene, needs, tracer);
    const int samples = sample_count(shot);
    TileRays tile_rays;
    const bool lens = needs[Part::lens];
    const bool together = goes_in_a_packet(screen, tile, lens);
    RayPacket packet;
    HitPacket found;
    for_each_pixel(tile, [&](int x, int y) { colour(x, y) = Rgb(0); });
    for (int sample = 0; sample < samples; ++sample) {
        tile_rays.clear();
        if (together) {
            aim(screen, shot, tile, sample, samples, packet);
            tracer.closest(RayKind::primary, packet, found);
            tile_rays.add(shot, tile, sample, packet, found);
        } else {
            for_each_pixel(tile, [&](int x, int y) {
                tile_rays.add(x, y, primary_ray(screen, shot, x, y, sample, samples, lens),
                              sample_key(shot, x, y, sample));
            });
            tile_rays.hits.resize(tile_rays.rays.size());
            tracer.closest(RayKind::primary, tile_rays.rays, tile_rays.hits);
        }
        if (lens) tracer.counts().did(Part::lens, tile_rays.rays.size());
        tile_rays.shade(whitted, colour);
    }
    if (samples == 1) return;
    for_each_pixel(tile, [&](int x, int y) { colour(x, y) /= static_cast<float>(samples); });
}

void shade_tile(const Scene& scene, const Shot& shot, const Tile& tile, const Needs& needs,
                Tracer& tracer, ImageView<const Hit> hits, ImageView<Rgb> colour) {
    const Screen screen(shot.camera, shot.size);
    TileRays tile_rays;
    for_each_pixel(tile, [&](int x, int y) {
        colour(x, y) = Rgb(0);
        tile_rays.add(x, y, screen.ray(x + 0.5, y + 0.5), sample_key(shot, x, y, 0));
    });
    for (const auto& [x, y] : tile_rays.pixels) tile_rays.hits.push_back(hits(x, y));
    tile_rays.shade(Whitted(scene, needs, tracer), colour);
}

void shade_tile(const Scene& scene, const Shot& shot, const Tile& tile, const Needs& needs,
                Tracer& tracer, const RayPacket& rays, const HitPacket& hits,
                ImageView<Rgb> colour) {
    for_each_pixel(tile, [&](int x, int y) { colour(x, y) = Rgb(0); });
    TileRays tile_rays;
    tile_rays.add(shot, tile, 0, rays, hits);
    tile_rays.shade(Whitted(scene, needs, tracer), colour);
}

Image<std::uint8_t> edges_of(ImageView<const Rgb> colour, Context& context) {
    Image<std::uint8_t> edges(colour.size());
    context.for_each_tile(colour.size(), [&](Tile tile, int) {
        for_each_pixel(tile, [&](int x, int y) { edges(x, y) = is_edge(colour, x, y) ? 1 : 0; });
    });
    return edges;
}

void antialias(const Scene& scene, const Shot& shot, const Needs& needs, Context& context,
               ImageView<Rgb> colour) {
    // The edges are found in the picture as it was, whatever the order of the tiles.
    const Image<std::uint8_t> edges = edges_of(colour, context);
    const Screen screen(shot.camera, shot.size);
    context.for_each_tile(colour.size(), [&](Tile tile, int worker) {
        context.tracer(worker).counts().did(Part::anti_aliasing, tile.area());
        const Whitted whitted(scene, needs, context.tracer(worker));
        for_each_pixel(tile, [&](int x, int y) {
            if (edges(x, y) == 0) return;
            Rgb sum = colour(x, y);
            for (int i = 0; i < antialias_samples; ++i) {
                const Vec2d& off = antialias_places[static_cast<std::size_t>(i)];
                const Ray ray = screen.ray(x + 0.5 + off.x, y + 0.5 + off.y);
                if (nowhere(ray)) continue;
                const Key key = radiance_key(shot, x, y, i + 1);
                sum += whitted.radiance(RayKind::primary, ray, key);
            }
            colour(x, y) = sum / static_cast<float>(antialias_samples + 1);
        });
    });
}

}  // namespace luch
