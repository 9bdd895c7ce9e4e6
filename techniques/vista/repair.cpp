#include "techniques/vista/repair.h"

#include <limits>

namespace luch::techniques::vista {
namespace {

/// Pixels that a triangle may touch: it is grown by this much, more than the pixel_grid() and its
/// own rounding move it.
constexpr double margin_px = 0x1p-8;
/// Depths are reckoned with less relative error than this, and t is rounded to float.
constexpr double rounding = 1 - 0x1p-16;

/// A linear function of the screen.
struct Linear {
    double at_zero, dx, dy;
    [[nodiscard]] double at(double x, double y) const { return at_zero + x * dx + y * dy; }
    /// The most that it grows within the margin.
    [[nodiscard]] double spread() const { return margin_px * (std::abs(dx) + std::abs(dy)); }
};

/// Twice the area that a point spans with the edge from a to b, divided by that of the triangle:
/// the weight of the corner opposite.
Linear weight(const Vec2d& a, const Vec2d& b, double area) {
    const Vec2d along = b - a;
    return {(along.y * a.x - along.x * a.y) / area, -along.y / area, along.x / area};
}

void push_nearer(const ScreenTri& triangle, Tile tile, ImageView<const NodeId> ids,
                 ImageView<float> second) {
    const auto& [a, b, c] = triangle.px;
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (!(std::abs(area) > 0)) return;
    const std::array<Linear, 3> w{weight(b, c, area), weight(c, a, area), weight(a, b, area)};
    const auto& inverse = triangle.inverse_depth;
    Linear depth{};
    for (std::size_t k = 0; k < 3; ++k) {
        depth.at_zero += w[k].at_zero * inverse[k];
        depth.dx += w[k].dx * inverse[k];
        depth.dy += w[k].dy * inverse[k];
    }
    const double most = std::max({inverse[0], inverse[1], inverse[2]});
    const auto first = [](double least, int from, int to) {
        return static_cast<int>(std::clamp(std::floor(least) - 1, double(from), double(to)));
    };
    const int x1 = first(std::max({a.x, b.x, c.x}) + 3, tile.x0, tile.x1);
    const int y1 = first(std::max({a.y, b.y, c.y}) + 3, tile.y0, tile.y1);
    for (int y = first(std::min({a.y, b.y, c.y}), tile.y0, tile.y1); y < y1; ++y) {
        for (int x = first(std::min({a.x, b.x, c.x}), tile.x0, tile.x1); x < x1; ++x) {
            if (ids(x, y) == triangle.node) continue;
            const bool outside = std::ranges::any_of(
                w, [&](const Linear& f) { return f.at(x + 0.5, y + 0.5) < -f.spread(); });
            if (outside) continue;
            const double nearest = std::min(depth.at(x + 0.5, y + 0.5) + depth.spread(), most);
            const auto z = static_cast<float>(rounding / nearest);
            second(x, y) = std::min(second(x, y), nearest > 0 ? z : second(x, y));
        }
    }
}

}  // namespace

void second_depths(std::span<const ScreenTri> triangles, Tile tile, ImageView<const NodeId> ids,
                   ImageView<float> second) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            second(x, y) = std::numeric_limits<float>::infinity();
        }
    }
    for (const ScreenTri& triangle : triangles) push_nearer(triangle, tile, ids, second);
}

void trace_doubtful(const Screen& screen, Tile tile, ImageView<const float> second, Tracer& tracer,
                    ImageView<Hit> hits, ImageView<std::uint8_t> fell_back) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            if (fell_back(x, y) != 0 || !(second(x, y) < std::numeric_limits<float>::infinity())) {
                continue;
            }
            const Ray ray = screen.ray(x + 0.5, y + 0.5);
            const double z = hits(x, y).t * glm::dot(ray.direction, screen.forward());
            if (hits(x, y) && z < rounding * second(x, y)) continue;
            hits(x, y) = tracer.closest(RayKind::primary, ray);
            fell_back(x, y) = 1;
        }
    }
}

}  // namespace luch::techniques::vista
