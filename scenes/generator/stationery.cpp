#include "scenes/generator/stationery.h"

#include "scenes/generator/lathe.h"

#include <cmath>

namespace luch::assets {

std::vector<Surface> pencil_body() {
    return lathe({{{0.38, 2.2}, {0.38, 17.5}}, {{0.38, 17.5}, {0, 17.5}}}, 6);
}

std::vector<Surface> pencil_wood() {
    return lathe({{{0.12, 0.7}, {0.37, 2.2}}}, 24);
}

std::vector<Surface> pencil_lead() {
    return lathe({{{0, 0}, {0.12, 0.7}}}, 24);
}

std::vector<Surface> open_book() {
    constexpr int columns = 40;
    constexpr double half_width = 15, height = 21, bulge = 13.5;
    Surface surface{"pages", {}, {}, {}, {}};
    for (const double row : {0.0, 1.0}) {
        for (int i = 0; i <= columns; ++i) {
            // From the middle d = 0 to the edge d = 1 a page rises by bulge · d · (1 − d)².
            const double side = 2.0 * i / columns - 1, d = std::abs(side);
            const double slope = bulge * (1 - d) * (1 - 3 * d) / half_width;
            surface.points.push_back(
                {half_width * side, height * row, -bulge * d * (1 - d) * (1 - d)});
            const double turn = d == 0 ? 0 : side < 0 ? slope : -slope;
            surface.normals.push_back(glm::normalize(Vec3d(turn, 0, -1)));
            surface.uvs.push_back({double(i) / columns, 1 - row});
        }
    }
    for (std::uint32_t i = 0; i < columns; ++i) {
        const Surface::Corner a{i, i}, b{i + 1, i + 1};
        const Surface::Corner c{i + columns + 1, i + columns + 1}, d{c.point + 1, c.uv + 1};
        surface.triangles.push_back({a, c, d});
        surface.triangles.push_back({a, d, b});
    }
    return {surface};
}

}  // namespace luch::assets
