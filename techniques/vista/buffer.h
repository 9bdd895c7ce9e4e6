#pragma once

#include "framework/technique/context.h"
#include "techniques/vista/vista.h"

namespace luch::techniques::vista {

/// The plumbing: calls the steps in their order on many threads and hands on what they make. Its
/// memory is kept from frame to frame.
class ClassicBuffer {
 public:
    explicit ClassicBuffer(const Steps& steps) : steps_(steps), reference_(reference()) {}

    /// lod, tessellate, clip, sort: the triangles in view.
    void collect(const Scene& scene, const Shot& shot, const Params& params, Context& context);
    /// project, rasterise.
    void paint(const Screen& screen, const Params& params, Context& context, ImageView<NodeId> ids,
               ImageView<float> depth);
    /// look_up, for one tile. Returns how many pixels fell back.
    std::uint64_t look_up(const Screen& screen, Tile tile, int worker, Context& context,
                          ImageView<const NodeId> ids, ImageView<Hit> hits,
                          ImageView<std::uint8_t> fell_back) const;

    [[nodiscard]] std::size_t triangle_count() const { return triangles_.size(); }
    /// z of the farthest corner that is not at infinity; 0 when there is none.
    [[nodiscard]] double farthest_depth() const;

 private:
    std::vector<Tri> in_view(NodeId id, const Scene& scene, const Shot& shot, const Params& params,
                             Context& context) const;
    void project(const Screen& screen, Context& context);
    void share_out(Size size);

    Steps steps_, reference_;
    std::vector<Tri> triangles_;  ///< in view, in painting order
    std::vector<ScreenTri> screen_triangles_;
    bool checked_ = false;  ///< hits count only when they are nearer than `second_`
    Image<float> second_;
    std::vector<std::vector<std::uint32_t>> bins_;  ///< of a tile: indices, in painting order
};

}  // namespace luch::techniques::vista
