#include "homework/vista/check/sight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace luch::homework::vista {
namespace {

using techniques::vista::Tri;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The pixels that may be met: around the corners' images when all are before the eye, else all.
Tile pixels_around(const Tri& triangle, const Screen& screen) {
    const auto [width, height] = screen.size();
    double x0 = infinity, y0 = infinity, x1 = -infinity, y1 = -infinity;
    for (const auto& [p, w] : triangle.corners) {
        const std::optional<Vec2d> px = screen.project(p);
        if (!px) return {0, 0, width, height};
        x0 = std::min(x0, px->x), x1 = std::max(x1, px->x);
        y0 = std::min(y0, px->y), y1 = std::max(y1, px->y);
    }
    const auto pixel = [](double at, int most) {
        return static_cast<int>(std::clamp(at, 0.0, double(most)));
    };
    return {pixel(std::floor(x0 - 1), width), pixel(std::floor(y0 - 1), height),
            pixel(std::ceil(x1 + 1), width), pixel(std::ceil(y1 + 1), height)};
}

void see(const Tri& triangle, const Screen& screen, Sight& sight) {
    const Vec3d a = triangle.corners[0].p, b = triangle.corners[1].p, c = triangle.corners[2].p;
    const double volume = glm::dot(glm::cross(a, b), c);
    if (!(std::abs(volume) > 0)) return;
    // Rows of the inverse of the matrix whose columns are the corners.
    const Vec3d rows[] = {glm::cross(b, c) / volume, glm::cross(c, a) / volume,
                          glm::cross(a, b) / volume};
    const Vec3d w{triangle.corners[0].w, triangle.corners[1].w, triangle.corners[2].w};
    const Tile tile = pixels_around(triangle, screen);
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const Vec3d d{((x + 0.5) / screen.size().width * 2 - 1) * screen.half_width(),
                          (1 - (y + 0.5) / screen.size().height * 2) * screen.half_height(), 1};
            const Vec3d lambda{glm::dot(rows[0], d), glm::dot(rows[1], d), glm::dot(rows[2], d)};
            if (lambda.x < 0 || lambda.y < 0 || lambda.z < 0) continue;
            ++sight.layers(x, y);
            const auto depth = static_cast<float>(1 / glm::dot(lambda, w));
            if (!(depth < sight.depth(x, y))) continue;
            sight.depth(x, y) = depth;
            sight.ids(x, y) = triangle.node;
        }
    }
}

}  // namespace

Sight sight_of(std::span<const Tri> triangles, const Screen& screen) {
    Sight sight{Image<std::uint32_t>(screen.size(), no_node),
                Image<float>(screen.size(), std::numeric_limits<float>::infinity()),
                Image<std::uint32_t>(screen.size(), 0)};
    for (const Tri& triangle : triangles) see(triangle, screen, sight);
    return sight;
}

}  // namespace luch::homework::vista
