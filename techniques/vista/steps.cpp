// The lecture's steps, in its order (tessellate has a file of its own). Weghorst, Hooper,
// Greenberg, "Improved Computational Methods for Ray Tracing", ACM Transactions on Graphics 3 (1),
// 1984, § 3.
#include "techniques/vista/vista.h"

#include <limits>
#include <numbers>

namespace luch::techniques::vista {
namespace {

/// A chord of n segments lies r · (1 − cos(π/n)) ≈ r · π²/(2n²) inside its circle. Solved for n.
int lod(const Geometry& geometry, float radius_px) {
    constexpr double allowed_error_px = 0.125;
    if (!std::holds_alternative<Sphere>(geometry)) return 0;
    const double n = std::numbers::pi * std::sqrt(radius_px / (2 * allowed_error_px));
    const double even = 2 * std::ceil(n / 2);
    return static_cast<int>(std::clamp(even, double(least_segments), double(most_segments)));
}

using Polygon = std::vector<Corner>;

/// Cuts off what lies outside one side (Sutherland, Hodgman 1974). The cut is always reckoned from
/// the corner inside, so that two triangles which share an edge also share the point where it is
/// cut.
void cut(const Polygon& polygon, const Vec3d& inward, Polygon& inside) {
    inside.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner& a = polygon[i];
        const Corner& b = polygon[(i + 1) % polygon.size()];
        const double at_a = glm::dot(inward, a.p), at_b = glm::dot(inward, b.p);
        if (at_a >= 0) inside.push_back(a);
        if ((at_a >= 0) == (at_b >= 0)) continue;
        const auto [in, out] = at_a >= 0 ? std::pair(a, b) : std::pair(b, a);
        const double at_in = std::max(at_a, at_b), at_out = std::min(at_a, at_b);
        const double s = at_in / (at_in - at_out);
        inside.push_back({in.p + s * (out.p - in.p), in.w + s * (out.w - in.w)});
    }
}

void clip(std::span<const Tri> triangles, const Frustum& frustum, std::vector<Tri>& inside) {
    inside.clear();
    Polygon polygon, rest;
    for (const Tri& triangle : triangles) {
        polygon.assign(triangle.corners.begin(), triangle.corners.end());
        for (const Vec3d& inward : frustum.inward) {
            cut(polygon, inward, rest);
            std::swap(polygon, rest);
        }
        for (std::size_t i = 2; i < polygon.size(); ++i) {
            inside.push_back({{polygon[0], polygon[i - 1], polygon[i]}, triangle.node});
        }
    }
}

/// The painter paints what is far first. (A triangle at infinity, w = 0, is the first of all.)
void sort(std::span<Tri> triangles) {
    const auto distance = [](const Tri& triangle) {
        double farthest = 0;
        for (const auto& [p, w] : triangle.corners) {
            farthest = std::max(
                farthest, w > 0 ? glm::length(p) / w : std::numeric_limits<double>::infinity());
        }
        return farthest;
    };
    std::vector<std::pair<double, const Tri*>> order;
    for (const Tri& triangle : triangles) order.emplace_back(distance(triangle), &triangle);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Tri> sorted;
    sorted.reserve(triangles.size());
    for (const auto& entry : order) sorted.push_back(*entry.second);
    std::copy(sorted.begin(), sorted.end(), triangles.begin());
}

/// x_px = (x / (z · half_width) + 1) / 2 · width, likewise y: Screen::ray solved for the pixel. The
/// point p/w has the same image as p, so points at infinity fall on their place on the horizon;
/// only the depth z/w depends on w.
void project(std::span<const Tri> triangles, const Screen& screen,
             std::span<ScreenTri> screen_triangles) {
    const double grid = pixel_grid(screen.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        ScreenTri result{.node = triangles[i].node};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& [p, w] = triangles[i].corners[k];
            const std::optional<Vec2d> px = screen.project(p);
            if (!px) {
                result = {};
                break;
            }
            result.px[k] = glm::round(*px / grid) * grid;
            result.inverse_depth[k] = w / p.z;
        }
        screen_triangles[i] = result;
    }
}

double cross(const Vec2d& a, const Vec2d& b) {
    return a.x * b.y - a.y * b.x;
}

/// One edge of a triangle whose inside is where the edge function (b − a) × (p − a) is positive. It
/// is reckoned from the same end whichever triangle asks, so both neighbours get the same number
/// but for its sign, and a centre is never in both or in neither. On the edge itself the top-left
/// rule decides.
struct Edge {
    Vec2d from, along;
    bool owned;

    Edge(const Vec2d& a, const Vec2d& b)
        : from(a.x < b.x || (a.x == b.x && a.y < b.y) ? a : b),
          along(b - a),
          owned(along.y < 0 || (along.y == 0 && along.x > 0)) {}

    [[nodiscard]] double at(const Vec2d& p) const { return cross(along, p - from); }
    [[nodiscard]] bool inside(double value) const { return value > 0 || (value == 0 && owned); }
};

/// The pixels first ≤ i < last of one axis whose centres lie between two coordinates.
std::pair<int, int> centres(double least, double most, int first, int last) {
    return {static_cast<int>(std::clamp(std::ceil(least - 0.5), double(first), double(last))),
            static_cast<int>(std::clamp(std::floor(most - 0.5) + 1, double(first), double(last)))};
}

/// Row by row. 1/z runs linearly over the screen, z does not: it is 1/z that is interpolated, with
/// the edge functions as weights.
void paint(const ScreenTri& triangle, Tile tile, Hidden hidden, ImageView<NodeId> ids,
           ImageView<float> depth) {
    const auto& [p0, p1, p2] = triangle.px;
    const double area = cross(p1 - p0, p2 - p0);
    if (!(std::abs(area) > 0)) return;
    const bool turned = area < 0;
    const int second = turned ? 2 : 1, third = turned ? 1 : 2;
    const Edge edges[] = {{triangle.px[second], triangle.px[third]},
                          {triangle.px[third], p0},
                          {p0, triangle.px[second]}};
    const Vec3d inverse_depth{triangle.inverse_depth[0], triangle.inverse_depth[second],
                              triangle.inverse_depth[third]};
    const auto [x0, x1] =
        centres(std::min({p0.x, p1.x, p2.x}), std::max({p0.x, p1.x, p2.x}), tile.x0, tile.x1);
    const auto [y0, y1] =
        centres(std::min({p0.y, p1.y, p2.y}), std::max({p0.y, p1.y, p2.y}), tile.y0, tile.y1);
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            const Vec2d centre{x + 0.5, y + 0.5};
            const Vec3d e{edges[0].at(centre), edges[1].at(centre), edges[2].at(centre)};
            if (!edges[0].inside(e[0]) || !edges[1].inside(e[1]) || !edges[2].inside(e[2]))
                continue;
            const auto z = static_cast<float>(std::abs(area) / glm::dot(e, inverse_depth));
            if (hidden == Hidden::depth && !(z < depth(x, y))) continue;
            ids(x, y) = triangle.node;
            depth(x, y) = z;
        }
    }
}

void rasterise(std::span<const ScreenTri> triangles, Tile tile, Hidden hidden,
               ImageView<NodeId> ids, ImageView<float> depth) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            ids(x, y) = no_node;
            depth(x, y) = std::numeric_limits<float>::infinity();
        }
    }
    for (const ScreenTri& triangle : triangles) paint(triangle, tile, hidden, ids, depth);
}

/// "No node" is taken for the background, and a hit for the nearest hit. Neither is certain.
void look_up(const Screen& screen, Tile tile, ImageView<const NodeId> ids, Tracer& tracer,
             ImageView<Hit> hits, ImageView<std::uint8_t> fell_back) {
    const auto width = static_cast<std::size_t>(tile.width());
    std::vector<Ray> rays(width);
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            rays[static_cast<std::size_t>(x - tile.x0)] = screen.ray(x + 0.5, y + 0.5);
        }
        tracer.test({&ids(tile.x0, y), width}, rays, {&hits(tile.x0, y), width});
        for (int x = tile.x0; x < tile.x1; ++x) {
            const bool missed = ids(x, y) != no_node && !hits(x, y);
            fell_back(x, y) = missed;
            if (!missed) continue;
            const Ray& ray = rays[static_cast<std::size_t>(x - tile.x0)];
            hits(x, y) = tracer.closest(RayKind::primary, ray);
        }
    }
}

}  // namespace

Steps reference() {
    return {lod, tessellate, clip, sort, project, rasterise, look_up};
}

}  // namespace luch::techniques::vista
