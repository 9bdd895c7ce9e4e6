#include "framework/baseline/classic.h"

#include <algorithm>

namespace luch {
namespace {

/// Adds what rays bring, their hits being known.
void shade(const Scene& scene, const Needs& needs, Tracer& tracer, const TileRays& tile_rays,
           const KnownLightOf& known, ImageView<Rgb> colour) {
    std::vector<Rgb> light(tile_rays.rays.size());
    const Whitted whitted(scene, needs, tracer, known ? known(tile_rays) : KnownLight{});
    whitted.shade(RayKind::primary, tile_rays.rays, tile_rays.hits, tile_rays.keys, light);
    for (std::size_t i = 0; i < light.size(); ++i) {
        const auto& [x, y] = tile_rays.pixels[i];
        colour(x, y) += light[i];
    }
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

void trace_tile(const Scene& scene, const Shot& shot, const Tile& tile, const Needs& needs,
                Tracer& tracer, ImageView<Rgb> colour, const KnownLightOf& known) {
    const Screen screen(shot.camera, shot.size);
    const int samples = sample_count(shot);
    TileRays tile_rays;
    for_each_pixel(tile, [&](int x, int y) { colour(x, y) = Rgb(0); });
    for (int sample = 0; sample < samples; ++sample) {
        tile_rays.shoot(screen, shot, tile, sample, needs, tracer);
        shade(scene, needs, tracer, tile_rays, known, colour);
    }
    if (samples == 1) return;
    for_each_pixel(tile, [&](int x, int y) { colour(x, y) /= static_cast<float>(samples); });
}

void shade_tile(const Scene& scene, const Shot& shot, const Tile& tile, const Needs& needs,
                Tracer& tracer, ImageView<const Hit> hits, ImageView<Rgb> colour,
                const KnownLightOf& known) {
    const Screen screen(shot.camera, shot.size);
    TileRays tile_rays;
    for_each_pixel(tile, [&](int x, int y) {
        colour(x, y) = Rgb(0);
        tile_rays.add(x, y, screen.ray(x + 0.5, y + 0.5), radiance_key(shot, x, y, 0));
    });
    for (const auto& [x, y] : tile_rays.pixels) tile_rays.hits.push_back(hits(x, y));
    shade(scene, needs, tracer, tile_rays, known, colour);
}

void shade_tile(const Scene& scene, const Shot& shot, const Tile& tile, const Needs& needs,
                Tracer& tracer, const RayPacket& rays, const HitPacket& hits,
                ImageView<Rgb> colour) {
    for_each_pixel(tile, [&](int x, int y) { colour(x, y) = Rgb(0); });
    TileRays tile_rays;
    tile_rays.add(shot, tile, 0, rays, hits);
    shade(scene, needs, tracer, tile_rays, {}, colour);
}

Image<std::uint8_t> edges_of(ImageView<const Rgb> colour, Context& context) {
    Image<std::uint8_t> edges(colour.size());
    context.for_each_tile(colour.size(), [&](Tile tile, int) {
        for_each_pixel(tile, [&](int x, int y) { edges(x, y) = is_edge(colour, x, y) ? 1 : 0; });
    });
    return edges;
}

void antialias(const Scene& scene, const Shot& shot, const Needs& needs, Context& context,
               ImageView<Rgb> colour, const KnownLightOfWorker& known_of) {
    // The edges are found in the picture as it was, whatever the order of the tiles.
    const Image<std::uint8_t> edges = edges_of(colour, context);
    context.for_each_tile(colour.size(), [&](Tile tile, int worker) {
        antialias_tile(scene, shot, tile, edges.view(), needs, context.tracer(worker), colour,
                       known_of ? known_of(worker) : KnownLightOf{});
    });
}

void trace_frame(const Scene& scene, const Shot& shot, const Needs& needs, Context& context,
                 ImageView<Rgb> colour, const KnownLightOfWorker& known_of) {
    context.for_each_tile(colour.size(), [&](Tile tile, int worker) {
        trace_tile(scene, shot, tile, needs, context.tracer(worker), colour,
                   known_of ? known_of(worker) : KnownLightOf{});
    });
    if (!needs[Part::anti_aliasing] || !may_antialias(shot)) return;
    antialias(scene, shot, needs, context, colour, known_of);
}

void antialias_tile(const Scene& scene, const Shot& shot, const Tile& tile,
                    ImageView<const std::uint8_t> edges, const Needs& needs, Tracer& tracer,
                    ImageView<Rgb> colour, const KnownLightOf& known) {
    tracer.counts().did(Part::anti_aliasing, tile.area());
    TileRays rays;
    for (int sample = 0; sample < antialias_samples; ++sample) {
        shoot_edges(shot, tile, sample, edges, tracer, rays);
        shade(scene, needs, tracer, rays, known, colour);
    }
    for_each_pixel(tile, [&](int x, int y) {
        if (edges(x, y) != 0) colour(x, y) /= static_cast<float>(antialias_samples + 1);
    });
}

void shoot_edges(const Shot& shot, const Tile& tile, int sample,
                 ImageView<const std::uint8_t> edges, Tracer& tracer, TileRays& rays) {
    const Screen screen(shot.camera, shot.size);
    const Vec2d& off = antialias_places[static_cast<std::size_t>(sample)];
    rays.clear();
    for_each_pixel(tile, [&](int x, int y) {
        if (edges(x, y) == 0) return;
        rays.add(x, y, screen.ray(x + 0.5 + off.x, y + 0.5 + off.y),
                 radiance_key(shot, x, y, sample + 1));
    });
    rays.trace(tracer);
}

}  // namespace luch
