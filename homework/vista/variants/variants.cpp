#include "homework/vista/check/others.h"
#include "homework/vista/check/paint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace luch::homework::vista {
namespace {

using namespace techniques::vista;

/// Looks for the answer instead of computing it, with another part of a pixel.
int lod_by_trying(const Geometry& geometry, float radius_px) {
    if (!std::holds_alternative<Sphere>(geometry)) return 0;
    int n = least_segments;
    while (n < most_segments && radius_px * (1 - std::cos(std::numbers::pi / n)) > 0.2) n += 2;
    return n;
}

int lod_generous(const Geometry& geometry, float radius_px) {
    if (!std::holds_alternative<Sphere>(geometry)) return 0;
    return std::min(most_segments, (reference().lod(geometry, radius_px) * 5 / 4 + 1) / 2 * 2);
}

/// The other way round, and the last triangle first.
void wound_backwards(const Geometry& geometry, int n, std::vector<Tri>& triangles) {
    reference().tessellate(geometry, n, triangles);
    for (Tri& triangle : triangles) std::swap(triangle.corners[1], triangle.corners[2]);
    std::reverse(triangles.begin(), triangles.end());
}

/// Boxes and squares are cut along the other diagonal, spheres turned by one meridian.
void other_diagonal(const Geometry& geometry, int n, std::vector<Tri>& triangles) {
    reference().tessellate(geometry, n, triangles);
    const auto* plane = std::get_if<Plane>(&geometry);
    const bool square = plane != nullptr && std::isfinite(plane->limit);
    if (!square && !std::holds_alternative<Cube>(geometry)) return;
    for (std::size_t i = 0; i + 1 < triangles.size(); i += 2) {
        const auto [a, b, c] = triangles[i].corners;
        const Corner d = triangles[i + 1].corners[2];
        triangles[i].corners = {a, b, d};
        triangles[i + 1].corners = {b, c, d};
    }
}

void sides_in_another_order(std::span<const Tri> triangles, const Frustum& frustum,
                            std::vector<Tri>& inside) {
    const auto& [a, b, c, d] = frustum.inward;
    reference().clip(triangles, {{c, a, d, b}}, inside);
}

/// The last triangle first.
void from_behind(std::span<const Tri> triangles, const Frustum& frustum, std::vector<Tri>& inside) {
    std::vector<Tri> turned(triangles.rbegin(), triangles.rend());
    reference().clip(turned, frustum, inside);
}

/// What is cut is rounded to float.
void clip_in_float(std::span<const Tri> triangles, const Frustum& frustum,
                   std::vector<Tri>& inside) {
    reference().clip(triangles, frustum, inside);
    for (Tri& triangle : inside) {
        for (auto& [p, w] : triangle.corners) {
            p = Vec3d(Vec3(p));
            w = static_cast<float>(w);
        }
    }
}

/// By squares of distances, on an index.
void sort_by_squares(std::span<Tri> triangles) {
    const auto square = [](const Tri& triangle) {
        double most = 0;
        for (const auto& [p, w] : triangle.corners) {
            most = std::max(
                most, w > 0 ? glm::dot(p, p) / (w * w) : std::numeric_limits<double>::infinity());
        }
        return most;
    };
    std::vector<std::size_t> order(triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const double at_a = square(triangles[a]), at_b = square(triangles[b]);
        return at_a != at_b ? at_a > at_b : a < b;
    });
    const std::vector<Tri> before(triangles.begin(), triangles.end());
    for (std::size_t i = 0; i < order.size(); ++i) triangles[i] = before[order[i]];
}

/// Its own arithmetic, in Real.
template <class Real>
void project_in(std::span<const Tri> triangles, const Screen& screen,
                std::span<ScreenTri> screen_triangles) {
    const double grid = pixel_grid(screen.size());
    const Real half_width = Real(screen.size().width) / 2;
    const Real half_height = Real(screen.size().height) / 2;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        ScreenTri result{.node = triangles[i].node};
        for (std::size_t k = 0; k < 3 && result.node != no_node; ++k) {
            const auto& [p, w] = triangles[i].corners[k];
            if (!(p.z > 0)) {
                result = {};
                break;
            }
            const Real inverse = 1 / Real(p.z);
            const Real x =
                half_width + Real(p.x) * inverse * (half_width / Real(screen.half_width()));
            const Real y =
                half_height - Real(p.y) * inverse * (half_height / Real(screen.half_height()));
            result.px[k] = {std::round(double(x) / grid) * grid,
                            std::round(double(y) / grid) * grid};
            result.inverse_depth[k] = Real(w) * inverse;
        }
        screen_triangles[i] = result;
    }
}

/// A pixel at a time.
void pixel_by_pixel(const Screen& screen, Tile tile, ImageView<const NodeId> ids, Tracer& tracer,
                    ImageView<Hit> hits, ImageView<std::uint8_t> fell_back) {
    for (int x = tile.x0; x < tile.x1; ++x) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            const Ray ray = screen.ray(x + 0.5, y + 0.5);
            hits(x, y) = {};
            fell_back(x, y) = 0;
            if (ids(x, y) == no_node) continue;
            tracer.test({&ids(x, y), 1}, {&ray, 1}, {&hits(x, y), 1});
            if (hits(x, y)) continue;
            hits(x, y) = tracer.closest(RayKind::primary, ray);
            fell_back(x, y) = 1;
        }
    }
}

/// A whole tile at once, its fallbacks together.
void all_at_once(const Screen& screen, Tile tile, ImageView<const NodeId> ids, Tracer& tracer,
                 ImageView<Hit> hits, ImageView<std::uint8_t> fell_back) {
    std::vector<Ray> rays, again;
    std::vector<NodeId> nodes;
    std::vector<std::size_t> missed;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            rays.push_back(screen.ray(x + 0.5, y + 0.5));
            nodes.push_back(ids(x, y));
        }
    }
    std::vector<Hit> found(rays.size());
    tracer.test(nodes, rays, found);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (nodes[i] == no_node || found[i]) continue;
        missed.push_back(i);
        again.push_back(rays[i]);
    }
    std::vector<Hit> traced(again.size());
    tracer.closest(RayKind::primary, again, traced);
    std::vector<std::uint8_t> marks(rays.size(), 0);
    for (std::size_t i = 0; i < missed.size(); ++i) {
        found[missed[i]] = traced[i];
        marks[missed[i]] = 1;
    }
    std::size_t i = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x, ++i) {
            hits(x, y) = found[i];
            fell_back(x, y) = marks[i];
        }
    }
}

}  // namespace

std::vector<grading::Other> variants() {
    using Tie = PaintRules::Tie;
    return {
        {"reference", "", "the reference itself", reference()},
        {"lod_by_trying", "vista.t1", "0.2 px, by trying", with(&Steps::lod, lod_by_trying)},
        {"lod_generous", "vista.t1", "a quarter more", with(&Steps::lod, lod_generous)},
        {"wound_backwards", "vista.t2", "other winding, other order",
         with(&Steps::tessellate, wound_backwards)},
        {"other_diagonal", "vista.t2", "squares along the other diagonal",
         with(&Steps::tessellate, other_diagonal)},
        {"sides_in_another_order", "vista.t3", "other polygons, other triangles",
         with(&Steps::clip, sides_in_another_order)},
        {"from_behind", "vista.t3", "the last triangle first", with(&Steps::clip, from_behind)},
        {"clip_in_float", "vista.t3", "rounded to float", with(&Steps::clip, clip_in_float)},
        {"sort_by_squares", "vista.t4", "squares of distances, std::sort on indices",
         with(&Steps::sort, sort_by_squares)},
        {"project_in_double", "vista.t5", "other arithmetic",
         with(&Steps::project, project_in<double>)},
        {"project_in_float", "vista.t5", "in float", with(&Steps::project, project_in<float>)},
        {"paint_in_double", "vista.t6", "other edge functions",
         with(&Steps::rasterise, Painter<double, PaintRules{}>::rasterise)},
        {"paint_in_float", "vista.t6", "in float",
         with(&Steps::rasterise, Painter<float, PaintRules{}>::rasterise)},
        {"bottom_right", "vista.t6", "the bottom-right rule",
         with(&Steps::rasterise, Painter<double, PaintRules{.tie = Tie::bottom_right}>::rasterise)},
        {"by_columns", "vista.t6", "column by column",
         with(&Steps::rasterise, Painter<double, PaintRules{.by_columns = true}>::rasterise)},
        {"pixel_by_pixel", "vista.t7", "a ray a call", with(&Steps::look_up, pixel_by_pixel)},
        {"all_at_once", "vista.t7", "a tile a call", with(&Steps::look_up, all_at_once)},
    };
}

}  // namespace luch::homework::vista
