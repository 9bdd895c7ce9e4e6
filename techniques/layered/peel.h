#pragma once

#include "framework/technique/technique.h"
#include "framework/trace/whitted.h"
#include "techniques/layered/fragments.h"

#include <optional>
#include <utility>
#include <vector>

namespace luch::techniques::layered {

/// Where a lens sees past an edge: within as many pixels of it as the radii of confusion of its two
/// sides differ.
class Openings {
 public:
    Openings(ImageView<const float> depth, const Lens& lens, int detail);

    /// The signed radius of the farthest thing that can be seen past a texel's surface; nothing
    /// where that one hides all.
    [[nodiscard]] std::optional<double> farthest(int x, int y) const;

    /// Surfaces whose radii differ by less are one.
    static constexpr double gap_px = 0.5;

 private:
    struct Opening {
        float reach = 0;  ///< texels
        float farthest = std::numeric_limits<float>::infinity();
    };
    void find(const Image<float>& radius, int detail);
    void spread();

    Image<float> radius_;
    Image<Opening> opens_;  ///< of blocks: edges in them
    Image<float> seen_;     ///< of blocks: the farthest of all edges that reach them
};

/// What was found behind the texels of a tile.
struct Peeled {
    std::vector<std::pair<int, int>> texels;
    std::vector<Hidden> hidden;
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::vector<Key> keys;
    std::size_t lit = 0;  ///< how many of them have their colour
};

/// Sees what is behind what is seen. Depth peeling (Everitt, 2001), with rays.
class Peeler {
 public:
    Peeler(const Scene& scene, const Shot& fine, const Lens& lens, const Needs& needs,
           Tracer& tracer);

    /// The surfaces behind a texel's first one down to a signed radius, each farther than the one
    /// before by more than Openings::gap_px. A ray that entered a solid does not see the far wall
    /// from inside: no lens ray could.
    void peel(int x, int y, const Hit& front, double deepest, Peeled& found) const;
    /// The first surface farther than `depth`.
    void beyond(int x, int y, float depth, Peeled& found) const;
    /// Lights what was found.
    void shade(Peeled& found) const;

 private:
    void keep(int x, int y, int index, const Ray& ray, const Hit& hit, Peeled& found) const;
    [[nodiscard]] float depth_of(const Ray& ray, const Hit& hit) const;

    const Scene* scene_;
    const Shot* fine_;
    const Lens* lens_;
    Screen screen_;
    Whitted whitted_;
    Needs needs_;
    Tracer* tracer_;
};

}  // namespace luch::techniques::layered
