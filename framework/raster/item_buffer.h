#pragma once

#include "framework/accel/accelerator.h"
#include "framework/parallel/workers.h"
#include "framework/scene/scene.h"

#include <memory>

namespace luch {

/// What a pixel shows: the triangle that is certainly the nearest, or none. Ambiguous where that
/// cannot be said for certain: an edge or two depths too close to tell, or something that is no
/// mesh. Then node and triangle mean nothing.
struct Item {
    NodeId node = no_node;
    std::uint32_t triangle = 0;
    bool ambiguous = false;
    bool operator==(const Item&) const = default;
};

/// Depths are inverse: 1/w, w the distance along the view axis; larger is nearer, 0 is nothing.
/// No hit of the item is farther than 1/nearest, nothing else in the pixel nearer than 1/second.
struct ItemDepths {
    float nearest = 0;
    float second = 0;
};

/// A tile of items, side by side as its rays are; of those beyond the frame nothing is known.
struct ItemPacket {
    NodeId node[RayPacket::capacity];  ///< no_node where there is no item, or none for certain
    bool ambiguous[RayPacket::capacity];
    ItemDepths depths[RayPacket::capacity];  ///< zero without with_depths
};

/// An item buffer (Weghorst, Hooper and Greenberg, "Improved Computational Methods for Ray
/// Tracing", 1984): the triangle that each pixel's ray hits, found by rasterising in three
/// dimensions: edges are planes through the eye, so nothing is clipped, projected or lost behind
/// it. Every decision has a bound on its error; what is not certain is marked, to be traced, and
/// all the rest gets the very hits that Accelerator::closest() finds. Nodes that are no meshes mark
/// the pixels where they may be nearest. For pinhole cameras; see applies().
class ItemBuffer {
 public:
    /// What becomes of nodes that are no meshes: they mark pixels, or are left to the caller, as if
    /// the scene did not have them.
    enum class Others { mark, ignore };

    /// Keeps a reference to the scene, which must outlive it. Any `isa` gives the same bits.
    explicit ItemBuffer(const Scene& scene, Isa isa = parsed_isa(""), Others others = Others::mark);
    ~ItemBuffer();
    ItemBuffer(ItemBuffer&&) noexcept;

    /// Whether a camera's rays come from one point and its frame is flat: perspective, no lens; the
    /// frame's sides must not exceed 16,384 pixels.
    [[nodiscard]] static bool applies(const Camera& camera, Size size);

    /// Draws the frame in which pixel (x, y) is seen along screen.ray(x + offset.x, y + offset.y).
    /// Any number of workers gives the same bits.
    void draw(const Screen& screen, const Vec2d& offset, const Workers& workers,
              bool with_depths = false);

    // Of the frame drawn last:
    [[nodiscard]] Size size() const;
    [[nodiscard]] Item item(int x, int y) const;
    /// Zero without with_depths.
    [[nodiscard]] ItemDepths depths(int x, int y) const;
    [[nodiscard]] std::uint64_t ambiguous_count() const;

    // The frame in tiles of 16 × 16 pixels, row by row.
    static constexpr int tile_side = 16;
    [[nodiscard]] int tile_count() const;
    /// The part of tile i that lies in the frame.
    [[nodiscard]] Tile tile(int i) const;
    /// Entry k of a tile's packets is this pixel of it: blocks of 4 × 4, row by row, in rows of
    /// four.
    [[nodiscard]] static int x_in_tile(int k) { return k / 16 % 4 * 4 + k % 4; }
    [[nodiscard]] static int y_in_tile(int k) { return k / 64 * 4 + k % 16 / 4; }
    /// The rays of a tile as draw() saw them; those beyond the frame look for nothing.
    [[nodiscard]] RayPacket rays(int tile) const;
    /// The hits of a tile's rays, which must be those of rays(); pixels that are ambiguous or empty
    /// get Hit{}. Returns the number of ambiguous ones.
    int resolve(int tile, const RayPacket& rays, HitPacket& hits) const;
    /// What the entries of a tile's packets show.
    void show(int tile, ItemPacket& items) const;
    /// Traces the ambiguous ones. After it, hits are those of accelerator.closest(rays, …).
    void trace_ambiguous(int tile, const RayPacket& rays, const Accelerator& accelerator,
                         HitPacket& hits, WorkCounts& work) const;

    /// Memory held, in bytes.
    [[nodiscard]] std::uint64_t bytes() const;

 private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace luch
