#include "framework/baseline/classic.h"

#include "framework/baseline/blocks.h"

namespace luch {
namespace {

/// What a sample's key is used for.
constexpr std::uint64_t radiance = 1;

/// The rays of a tile's pixels, but for pixels that no ray goes through.
struct TileRays {
    std::vector<std::pair<int, int>> pixels;
    std::vector<Ray> rays;
    std::vector<Key> keys;
    std::vector<Rgb> light;

    void clear() {
        pixels.clear();
        rays.clear();
        keys.clear();
    }
    void add(int x, int y, const Ray& ray, Key key) {
        if (nowhere(ray)) return;
        pixels.emplace_back(x, y);
        rays.push_back(ray);
        keys.push_back(key);
    }
    /// Adds what the rays bring, their hits being known.
    void shade(const Whitted& whitted, std::span<const Hit> hits, ImageView<Rgb> colour) {
        light.resize(rays.size());
        whitted.shade(RayKind::primary, rays, hits, keys, light);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            colour(pixels[i].first, pixels[i].second) += light[i];
        }
    }
};

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
    std::vector<Hit> hits;
    const bool lens = needs[Part::lens];
    for_each_pixel(tile, [&](int x, int y) { colour(x, y) = Rgb(0); });
    for (int sample = 0; sample < samples; ++sample) {
        tile_rays.clear();
        for_each_pixel(tile, [&](int x, int y) {
            tile_rays.add(x, y, primary_ray(screen, shot, x, y, sample, samples, lens),
                          radiance_key(shot, x, y, sample));
        });
        if (lens) tracer.counts().did(Part::lens, tile_rays.rays.size());
        hits.resize(tile_rays.rays.size());
        tracer.closest(RayKind::primary, tile_rays.rays, hits);
        tile_rays.shade(whitted, hits, colour);
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
        tile_rays.add(x, y, screen.ray(x + 0.5, y + 0.5), radiance_key(shot, x, y, 0));
    });
    std::vector<Hit> found;
    for (const auto& [x, y] : tile_rays.pixels) found.push_back(hits(x, y));
    tile_rays.shade(Whitted(scene, needs, tracer), found, colour);
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
