#pragma once

#include "framework/image/image.h"
#include "framework/scene/scene.h"
#include "framework/technique/technique.h"
#include "framework/trace/tracer.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

// An item buffer (Weghorst, Hooper, Greenberg, "Improved Computational Methods for Ray Tracing",
// 1984), in the lecture's form. README.md has the idea, the formulas and where it fails.
namespace luch::techniques::vista {

/// A corner of a triangle in homogeneous coordinates: the point p/w or, where w = 0, the point at
/// infinity in direction p. 0 ≤ w ≤ 1.
struct Corner {
    Vec3d p{0};
    double w = 1;
    bool operator==(const Corner&) const = default;
};

/// A triangle that stands for a piece of a node's surface. In the node's own coordinates when
/// tessellate() makes it, in view space (the eye is the origin; x right, y up, z forward)
/// afterwards.
struct Tri {
    std::array<Corner, 3> corners;
    NodeId node = no_node;
    bool operator==(const Tri&) const = default;
};

/// The view volume in view space: p with inward · p ≥ 0 for all four sides. Each side holds the
/// eye, so w does not enter, and together they leave nothing behind the eye: no near plane is
/// needed.
struct Frustum {
    std::array<Vec3d, 4> inward;
};
Frustum frustum_of(const Screen& screen);

/// A triangle on the screen.
struct ScreenTri {
    std::array<Vec2d, 3> px{};              ///< corners in pixel coordinates, on the pixel_grid()
    std::array<double, 3> inverse_depth{};  ///< 1/z in view space; 0 at infinity
    NodeId node = no_node;
    bool operator==(const ScreenTri&) const = default;
};

/// Screen coordinates are rounded to multiples of this power of two (2⁻¹⁶ px at 640 × 480, 2⁻¹² at
/// 16,384²). It is the finest for which the edge functions of a triangle on the screen are exact in
/// double: their factors then have 26 bits.
double pixel_grid(Size size);

/// How rasterise() decides which triangle is seen.
enum class Hidden { painter, depth };

/// classic: the lecture's algorithm, made of the steps below. exact: the framework's item buffer of
/// triangles, and hulls around what is no mesh; every pixel gets the baseline's own hit.
enum class Mode { exact, classic };

/// What is repaired of the classic's holes. circumscribed: spheres get polyhedra around them, so
/// that nothing is lost beside them. both: a hit also counts only when it is certainly nearer than
/// all other nodes' triangles in the pixel; else the ray is traced.
enum class Repair { none, circumscribed, both };

/// The lecture's steps; a homework replaces one after the other. A step reads what it likes and
/// writes only what is named as its result; any tiling gives the same bits. Results that are
/// vectors are replaced.
struct Steps {
    /// How many segments a sphere needs whose radius appears as `radius_px` (> 0, maybe infinite):
    /// an even number, 4…128. For every other shape 0: it has triangles of its own.
    int (*lod)(const Geometry& geometry, float radius_px);

    /// Representative triangles, in the geometry's own coordinates. n: segments around a sphere.
    /// Where two triangles meet, they share their corners bit for bit.
    void (*tessellate)(const Geometry& geometry, int n, std::vector<Tri>& triangles);

    /// The parts of the triangles inside the view volume, as triangles. One that lies inside
    /// altogether is kept as it is, bit for bit.
    void (*clip)(std::span<const Tri> triangles, const Frustum& frustum, std::vector<Tri>& inside);

    /// Far to near: by falling distance from the eye (the origin) of the farthest corner. Triangles
    /// at the same distance keep their order.
    void (*sort)(std::span<Tri> triangles);

    /// The inverse of Screen::ray, rounded to the pixel_grid(). screen_triangles is as long as
    /// triangles; one with a corner that has no image (z ≤ 0) becomes ScreenTri{}, which covers
    /// nothing.
    void (*project)(std::span<const Tri> triangles, const Screen& screen,
                    std::span<ScreenTri> screen_triangles);

    /// Writes every pixel of a tile: node and depth (z in view space) of the triangle that covers
    /// its centre, no_node and infinity where none does. A centre on an edge belongs to the
    /// triangle that has it as a top or left edge. painter: a later triangle covers an earlier one;
    /// depth: only where it is nearer.
    void (*rasterise)(std::span<const ScreenTri> triangles, Tile tile, Hidden hidden,
                      ImageView<NodeId> ids, ImageView<float> depth);

    /// The hit of every pixel of a tile: its ray against the one node that the buffer names; when
    /// that misses, a full primary ray, and fell_back is 1 (else 0). Nothing where no node is
    /// named.
    void (*look_up)(const Screen& screen, Tile tile, ImageView<const NodeId> ids, Tracer& tracer,
                    ImageView<Hit> hits, ImageView<std::uint8_t> fell_back);
};

/// The steps as the lecture has them.
Steps reference();

/// Representative triangles: the reference step, in a file of its own.
void tessellate(const Geometry& geometry, int n, std::vector<Tri>& triangles);

/// What a user may set.
struct Params {
    int mode = 0;      ///< an index: Mode
    int segments = 0;  ///< of every sphere; 0: by its size
    int hidden = 0;    ///< an index: Hidden; of the classic
    int repair = 0;    ///< an index: Repair; of the classic
};

/// 0, or what is asked for, as far as it makes a polyhedron.
int asked_segments(const Params& params);

/// Segments that lod() may answer, and that a user may ask for.
inline constexpr int least_segments = 4, most_segments = 128;

/// The technique, made of these steps; each one's holes are filled by the reference. `mode`: what
/// it starts with.
std::unique_ptr<Technique> make(const Steps& steps, Mode mode = Mode::classic);

/// Its parameter to walk along.
extern const std::span<const double> segments_sweep;

}  // namespace luch::techniques::vista
