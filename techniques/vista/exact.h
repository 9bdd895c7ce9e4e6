#pragma once

#include "framework/raster/item_buffer.h"
#include "framework/technique/context.h"
#include "framework/technique/technique.h"
#include "techniques/vista/stand_ins.h"

#include <optional>

namespace luch::techniques::vista {

/// What exact mode shows of a frame.
struct ExactPlanes {
    ImageView<NodeId> ids;
    ImageView<std::uint32_t> triangles;  ///< of meshes; else no_node
    ImageView<std::uint8_t> fell_back;
    ImageView<float> lod;  ///< segments of the polyhedron that a pixel shows; 0: none
};

/// The primary hits of a frame, bit for bit those of Tracer::closest(), with few searches: of
/// meshes from triangle ids; of the rest, the one node whose hull is in front is tested, and counts
/// when its hit is certainly nearer than the next hull. What stays in doubt is traced.
class ExactBuffer {
 public:
    /// More have no numbers in the framework's buffer.
    static constexpr std::uint64_t most_triangles = 0x7ffffffe;

    /// Keeps a reference to the scene until the next call.
    void prepare(const Scene& scene);
    /// Draws meshes and hulls; without stand_ins, nodes that are no meshes are all tested, in every
    /// pixel.
    void draw(const Shot& shot, int segments, bool stand_ins, Context& context);

    /// Finds the hits of a tile that lies in one of Context's tiles: rays and hits in the order of
    /// for_each_pixel(), as shade_tile() wants them. Without `planes` nothing is shown.
    void look_up(Tile tile, Tracer& tracer, const ExactPlanes* planes, RayPacket& rays,
                 HitPacket& hits) const;

    [[nodiscard]] const Hulls& hulls() const { return hulls_; }

 private:
    const Scene* scene_ = nullptr;
    std::vector<bool> is_mesh_;  ///< of a node; empty: all are
    std::optional<Screen> screen_;
    std::optional<ItemBuffer> meshes_, fronts_;
    Hulls hulls_;
};

}  // namespace luch::techniques::vista
