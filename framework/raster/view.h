#pragma once

#include "framework/accel/hit.h"
#include "framework/raster/facet.h"
#include "framework/scene/camera.h"
#include "framework/scene/scene.h"

// A frame as seen from the coordinates of one node.
namespace luch::raster {

/// Which point of every pixel is looked at: pixel (x, y) is seen along
/// screen.ray(x + offset.x, y + offset.y).
struct Sight {
    const Screen* screen;
    Vec2d offset;
    /// The pixel that X and Y are counted from: the middle of the frame.
    [[nodiscard]] int middle_x() const { return screen->size().width / 2; }
    [[nodiscard]] int middle_y() const { return screen->size().height / 2; }
};

/// The rays of a frame in a node's coordinates, but longer: pixel (X, Y) counted from the middle is
/// seen along D(X, Y) = d + X·dx + Y·dy, whose share along the view axis is 1. So a point that
/// stands at `w` along the view axis is met at t = w in lengths of D; 1/t is what depths are
/// compared by ("inverse depth", larger is nearer), and is the same number for all nodes.
struct View {
    float origin[3];
    float d[3], dx[3], dy[3];
    double d_exact[3], dx_exact[3], dy_exact[3];  ///< the same before rounding
    float step;                                   ///< Σ |dx_i| + |dy_i|
    float sum;  ///< no Σ |d_i| + |X dx_i| + |Y dy_i| of a pixel exceeds it
    /// A point a relative to the origin stands at (w, X·w, Y·w) = (a·to_w, a·to_x, a·to_y), off by
    /// no more than 2⁻²⁰ · max|a_i| times the sum of |components|, which is `size_…`.
    float to_w[3], to_x[3], to_y[3];
    float size_w, size_x, size_y;
    /// What no ray sees: a·plane < −slack · max|a_i|; behind the eye, and beyond the frame's sides.
    float plane[5][3];
    float slack[5];
    int middle_x, middle_y, width, height;
    std::uint32_t base;  ///< the item of the node's first triangle
    bool cull_backfaces;
    /// Nothing can be said: the numbers overflow, or the transform is all but singular.
    bool hopeless;
};

View view_of(const Sight& sight, const Node& node);

/// A part of the frame that holds all that can be seen of a box, and the largest inverse depth of
/// anything in it (infinite where the eye is near it or in it). Empty spans: not seen.
struct Extent {
    Span span;
    float nearest;
};

/// `box` in the node's own coordinates, relative to the view's origin. Rays that miss the box by
/// rounding count as well: hits are clamped to slabs.
Extent extent_of(const View& view, const Boxd& box);

/// Of a box in the world, padded by `slack` of its farthest corner's distance; an unbounded one is
/// everywhere.
Extent world_extent_of(const Sight& sight, const Boxd& box, double slack);

Extent everywhere(Size size);

}  // namespace luch::raster
