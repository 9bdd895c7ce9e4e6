#pragma once

#include "framework/parallel/workers.h"
#include "framework/raster/kernels.h"
#include "framework/scene/scene.h"

#include <memory>
#include <vector>

// What an item buffer keeps: of a scene, and of the frame that was drawn last.
namespace luch::raster {

/// A scene ready to be drawn.
struct Stock {
    /// A node with a mesh; its items are base, base + 1, …
    struct Model {
        NodeId node;
        const Soup* soup;
        std::uint32_t base;
    };
    /// A node without one: pixels where it may be seen are ambiguous.
    struct Other {
        Boxd box;
        double slack;
    };
    std::vector<std::unique_ptr<Soup>> soups;  ///< by geometry, null for what is no mesh
    std::vector<Model> models;                 ///< by base
    std::vector<Other> others;

    [[nodiscard]] const Model& model_of(std::uint32_t item) const;
    [[nodiscard]] std::uint64_t bytes() const;
};

/// `with_others` false: nodes without a mesh are not there.
Stock stock_of(const Scene& scene, bool with_others = true);

/// The facets of one chunk of one node.
struct Batch {
    const View* view;
    const Soup* soup;
    std::uint32_t chunk;
    float nearest;            ///< the inverse depth of its box
    int first_row, last_row;  ///< of bins that its facets touch
    std::vector<Facet> facets;
    std::vector<Span> spans;
};

class Frame {
 public:
    std::vector<std::uint32_t> items;  ///< bin by bin, tile by tile, cell by cell
    std::vector<float> near, second;   ///< the same way, where they are wanted

    void draw(const Scene& scene, const Stock& stock, const Kernels& kernels, const Sight& sight,
              const Workers& workers, bool with_depths);

    /// The number of tile (x, y) in that order.
    [[nodiscard]] int tile_at(int x, int y) const {
        return (y / 4 * bins_across_ + x / 4) * 16 + y % 4 * 4 + x % 4;
    }
    [[nodiscard]] std::uint64_t bytes() const;

 private:
    void look(const Scene& scene, const Stock& stock, const Sight& sight);
    void set_up(const Kernels& kernels, const Workers& workers);
    void sort_into_row(int row, std::vector<std::vector<Entry>>& bins) const;
    void draw_row(const Kernels& kernels, int row, std::vector<std::vector<Entry>>& bins);

    Size size_;
    int bins_across_ = 0, bins_down_ = 0;
    std::vector<View> views_;
    std::vector<Batch> batches_;                         ///< from near to far
    std::size_t seen_ = 0;                               ///< how many of them are in use
    Batch marks_;                                        ///< what is no triangle
    std::vector<std::vector<std::vector<Entry>>> bins_;  ///< of a row, for each worker
};

}  // namespace luch::raster
