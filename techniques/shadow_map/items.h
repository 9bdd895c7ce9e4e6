#pragma once

#include "framework/trace/surface.h"
#include "framework/trace/tracer.h"
#include "techniques/shadow_map/content.h"
#include "techniques/shadow_map/cube.h"

namespace luch::techniques::shadow_map {

/// Something that rays through a texel may meet: a triangle of a mesh, or a whole shape.
struct Item {
    /// Of a shape that is not looked at here: a shadow ray must.
    static constexpr std::uint32_t not_tested = ~0u;

    /// Nothing of it is nearer along the face's axis.
    float nearest = 0;
    NodeId node = no_node;  ///< no_node: nothing is known of what lies from here on
    std::uint32_t primitive = 0;
};

/// The items of a face's window, of each texel from near to far.
struct ItemFace {
    Tile window;
    std::vector<Item> everywhere;      ///< so near to the light that they may be met anywhere
    std::vector<std::uint32_t> first;  ///< of each texel, row by row, in `items`; and the end
    std::vector<Item> items;
};

/// An item buffer from a light, conservative over whole texels: no ray through a texel meets
/// anything else before the receiver (Haines and Greenberg, "The Light Buffer: A Shadow-Testing
/// Accelerator", 1986).
struct Items {
    int n = 0;
    std::array<ItemFace, faces_of_cube> faces;

    [[nodiscard]] std::uint64_t bytes() const;
};

/// A texel keeps the nearest so many.
inline constexpr std::size_t most_items = 24;

/// Makes a face; `texels`: the size of its window.
ItemFace items_of(const Scene& scene, const Content& content, const Vec3d& light, int face, int n,
                  const Tile& window);

/// Whether something blocks a shadow ray from the light: by the functions that every other ray asks
/// too (1, 0: share of light), or ShadowSource::unknown. Counts object tests. `own`: a node that
/// certainly does not.
float share_by_items(const Items& items, const Scene& scene, const Ray& shadow, Counts& counts,
                     NodeId own = no_node);

/// The receiver's node, when it is convex and the ray to the receiver certainly ends before it: it
/// comes from outside, and so steeply that no t of a hit would be rounded to less than 1. Else
/// no_node.
NodeId own_convex(const Scene& scene, const Surface& surface, const Ray& shadow);

}  // namespace luch::techniques::shadow_map
