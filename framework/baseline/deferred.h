#pragma once

#include "framework/baseline/classic.h"

#include <vector>

namespace luch {

/// Some pixels' rays, what they meet and what that shows, shaded as the baseline does but not
/// summed: for techniques that do the sums in a way of their own. Reused from tile to tile.
struct DeferredPixels : TileRays {
    std::vector<Rgb> light;  ///< the sum, as the baseline has it
    ShadedParts parts;       ///< what it is made of

    /// Finds the light of all rays, their hits being known.
    void shade(const Scene& scene, const Needs& needs, Tracer& tracer);
};

/// One sample of every pixel of a tile. trace_tile() takes the same rays, counts them the same, and
/// its colours are the means of this light.
void defer_tile(const Scene& scene, const Shot& shot, const Tile& tile, int sample,
                const Needs& needs, Tracer& tracer, DeferredPixels& pixels);

/// The pixels of a tile that the scene's own anti-aliasing takes more samples of (see antialias()),
/// one more sample of each: 0 ≤ sample < antialias_samples. `edges` is edges_of() the picture.
void defer_edges(const Scene& scene, const Shot& shot, const Tile& tile, int sample,
                 ImageView<const std::uint8_t> edges, const Needs& needs, Tracer& tracer,
                 DeferredPixels& pixels);

}  // namespace luch
