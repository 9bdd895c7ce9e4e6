#pragma once

#include "framework/accel/isa.h"
#include "framework/accel/packet.h"
#include "framework/raster/facet.h"
#include "framework/raster/soup.h"
#include "framework/raster/view.h"

namespace luch::raster {

/// A node for resolve().
struct Target {
    const Triangle* triangles;
    std::uint32_t base, count;  ///< its items
    NodeId node;
    const Transform* to_object;
    bool cull_backfaces;
};

/// How many items are ambiguous; the lowest and highest of the others, or no_item and 0.
struct Survey {
    int ambiguous;
    std::uint32_t lowest, highest;
};

/// The stages, compiled for one level of the processor. All levels give the same bits.
struct Kernels {
    /// Sets up `count` blocks for a frame; writes the entries' facets and spans (room for
    /// block_width a block) and returns how many may be seen. Items count up from view.base.
    int (*set_up)(const View&, const Block* blocks, int count, Facet* facets, Span* spans);
    /// Draws one bin, whose first pixel is (x, y): `near` and
    /// `second`, where they are wanted (not null), and `items` get pixels_of_bin numbers each, cell
    /// by cell. The spans count from the bin's first pixel.
    void (*draw)(const Entry* entries, int count, int x, int y, float* near, float* second,
                 std::uint32_t* items);
    /// What the 256 items of a tile are.
    Survey (*survey)(const std::uint32_t* items);
    /// Hit{} for a whole tile.
    void (*miss)(HitPacket& hits);
    /// The hits of a tile's 256 rays with the triangles that `items` name; those that name none of
    /// this target's become Hit{} if `fresh`, else they are left alone.
    void (*resolve)(const Target&, const std::uint32_t* items, const RayPacket& rays, bool fresh,
                    HitPacket& hits);
};

const Kernels& kernels_plain();
const Kernels& kernels_v2();
const Kernels& kernels_v3();
const Kernels& kernels_v4();

/// Completes a facet that is no regular one: its kind, span and doubt. Out: whether it can be seen.
/// `box` is the triangle's, relative to the origin; `sane`: its edge values mean something.
bool complete(const View& view, const Box& box, bool sane, bool turned, Facet& facet, Span& span);

}  // namespace luch::raster
