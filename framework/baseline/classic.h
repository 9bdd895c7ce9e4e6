#pragma once

#include "framework/baseline/tile_rays.h"
#include "framework/technique/context.h"
#include "framework/trace/whitted.h"

#include <array>
#include <functional>

namespace luch {

/// What is known of the light at some rays of a tile, their hits being known; asked before they are
/// shaded. What it points to is used until then only.
using KnownLightOf = std::function<KnownLight(const TileRays&)>;
/// The same, to be asked by each worker before each of its tiles; used until it asks again.
using KnownLightOfWorker = std::function<KnownLightOf(int worker)>;

/// Fills a tile with the mean of all of a pixel's samples, hits found by tracing. Where there is no
/// ray it is black.
void trace_tile(const Scene& scene, const Shot& shot, const Tile& tile, const Needs& needs,
                Tracer& tracer, ImageView<Rgb> colour, const KnownLightOf& known = {});

/// The same with one sample a pixel, the hits of the pixels' centres being known already (from an
/// item buffer…). Bit for bit what trace_tile() makes of the same hits.
void shade_tile(const Scene& scene, const Shot& shot, const Tile& tile, const Needs& needs,
                Tracer& tracer, ImageView<const Hit> hits, ImageView<Rgb> colour,
                const KnownLightOf& known = {});

/// The same when rays and hits are in packets, in the order of for_each_pixel(); the tile has no
/// more pixels than a packet rays.
void shade_tile(const Scene& scene, const Shot& shot, const Tile& tile, const Needs& needs,
                Tracer& tracer, const RayPacket& rays, const HitPacket& hits,
                ImageView<Rgb> colour);

/// Where the scene's own anti-aliasing takes its further samples, from the pixel's centre.
inline constexpr int antialias_samples = 4;
inline constexpr std::array<Vec2d, antialias_samples> antialias_places{
    Vec2d{-0.3, -0.3}, {0.3, -0.3}, {-0.3, 0.3}, {0.3, 0.3}};

/// 1 where it takes them, else 0.
Image<std::uint8_t> edges_of(ImageView<const Rgb> colour, Context& context);

/// The scene's own anti-aliasing, as the course has it: where a pixel or a neighbour differs from
/// the mean of the five by more than 0.1 in a displayed channel, four more samples are taken around
/// the centre. A heuristic: an edge that no pixel's centre saw stays jagged.
void antialias(const Scene& scene, const Shot& shot, const Needs& needs, Context& context,
               ImageView<Rgb> colour, const KnownLightOfWorker& known_of = {});

/// A tile of it. `edges` is edges_of() the picture.
void antialias_tile(const Scene& scene, const Shot& shot, const Tile& tile,
                    ImageView<const std::uint8_t> edges, const Needs& needs, Tracer& tracer,
                    ImageView<Rgb> colour, const KnownLightOf& known = {});

/// A whole frame: every tile traced and, where scene and shot ask for it, antialiased.
void trace_frame(const Scene& scene, const Shot& shot, const Needs& needs, Context& context,
                 ImageView<Rgb> colour, const KnownLightOfWorker& known_of = {});

/// The rays of its samples and their hits: 0 ≤ sample < antialias_samples.
void shoot_edges(const Shot& shot, const Tile& tile, int sample,
                 ImageView<const std::uint8_t> edges, Tracer& tracer, TileRays& rays);

}  // namespace luch
