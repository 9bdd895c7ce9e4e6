// Homework: the item buffer, step by step. This is the only file to edit; README.md (and
// README.bg.md) has the tasks. What is not written yet is done by the reference, so begin where you
// like. techniques/vista/vista.h says what each step is given and what it must leave behind.
#include "framework/technique/catalogue.h"
#include "framework/technique/todo.h"
#include "techniques/vista/vista.h"

namespace luch::homework::vista {
namespace {

using namespace techniques::vista;

/// t1. How round must a sphere be? A circle of radius r and the polygon with n corners on it are
/// r · (1 − cos(π/n)) apart at most. Find n so that this is a fraction of a pixel; then even, and
/// between least_segments and most_segments. 0 for shapes other than Sphere
/// (std::holds_alternative<Sphere>(geometry)).
int lod(const Geometry& geometry, float radius_px) {
    LUCH_TODO("vista.t1");
}

/// t2. Triangles that stand for a shape (std::get_if<Sphere>(&geometry), and so on):
/// a sphere: corners centre + R·(sin θ cos φ, cos θ, sin θ sin φ), n meridians φ, n/2 bands of θ;
/// a cube and a Plane with a limit: two triangles a face; a mesh: its own (mesh.corner(i, k));
/// an infinite plane: corners may lie at infinity, {direction, 0}. Three of them and one point will
/// do for a half, two of them and one point for a quarter.
void tessellate(const Geometry& geometry, int n, std::vector<Tri>& triangles) {
    LUCH_TODO("vista.t2");
}

/// t3. Keep what is inside all four sides: d(p) = inward · p ≥ 0. Where an edge crosses a side, the
/// crossing is a + s·(b − a) with s = d(a) / (d(a) − d(b)), for p and for w. A triangle that is cut
/// becomes a polygon of up to seven corners; cut that into triangles again. Two neighbours must cut
/// their common edge in the same point, to the last bit, or light falls through the crack.
void clip(std::span<const Tri> triangles, const Frustum& frustum, std::vector<Tri>& inside) {
    LUCH_TODO("vista.t3");
}

/// t4. Far to near, by the farthest corner: |p| / w, infinite where w = 0. The eye is the origin.
/// Equally far triangles keep their order.
void sort(std::span<Tri> triangles) {
    LUCH_TODO("vista.t4");
}

/// t5. Screen::ray sends pixel (x, y) along (sx, sy, 1) with sx = (2x/width − 1)·half_width and
/// sy = (1 − 2y/height)·half_height. Turn that round: which (x, y) does p fall on? Round it to
/// multiples of pixel_grid(). The depth is z/w; store its inverse. A corner with z ≤ 0 has no
/// image: leave ScreenTri{} for its triangle.
void project(std::span<const Tri> triangles, const Screen& screen,
             std::span<ScreenTri> screen_triangles) {
    LUCH_TODO("vista.t5");
}

/// t6. Clear the tile, then paint triangle after triangle, row by row. The edge function
/// e(p) = (b − a) × (p − a) tells on which side of the edge from a to b a pixel's centre
/// (x + ½, y + ½) lies. On the edge itself only one of the two neighbours may paint: the one that
/// has it as a top or a left edge. 1/z, not z, runs linearly over the screen; the weights of the
/// corners are the edge functions of the edges opposite to them, divided by their sum.
void rasterise(std::span<const ScreenTri> triangles, Tile tile, Hidden hidden,
               ImageView<NodeId> ids, ImageView<float> depth) {
    LUCH_TODO("vista.t6");
}

/// t7. The ray of a pixel is screen.ray(x + 0.5, y + 0.5). tracer.test() tries it on the node that
/// the buffer names, many rays a call; a ray whose node is no_node misses and costs nothing. When a
/// named node is missed: tracer.closest(RayKind::primary, ray), and fell_back is 1, else 0.
void look_up(const Screen& screen, Tile tile, ImageView<const NodeId> ids, Tracer& tracer,
             ImageView<Hit> hits, ImageView<std::uint8_t> fell_back) {
    LUCH_TODO("vista.t7");
}

}  // namespace

/// What the technique is made of, and what `luch check vista` tries.
Steps steps() {
    return {lod, tessellate, clip, sort, project, rasterise, look_up};
}

TechniqueInfo describe() {
    return {.name = "homework/vista",
            .title = "item buffer: yours",
            .topic = "3. Vista buffer",
            .create = [] { return make(steps()); },
            .sweep = {"segments", segments_sweep}};
}

}  // namespace luch::homework::vista
