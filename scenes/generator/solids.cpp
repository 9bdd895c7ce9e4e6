#include "scenes/generator/solids.h"

#include <cmath>
#include <numbers>

namespace luch::assets {

void add_box(Part& part, const Vec3d& centre, const Vec3d& half) {
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const double side : {-1.0, 1.0}) {
            const auto first = static_cast<std::uint32_t>(part.points.size());
            for (int i = 0; i < 4; ++i) {
                const double s = i % 2 == 0 ? -1 : 1, t = i < 2 ? -1 : 1;
                Vec3d offset, normal(0);
                offset[axis] = side * half[axis];
                offset[u] = s * half[u];
                offset[v] = t * half[v];
                normal[axis] = side;
                part.points.push_back(centre + offset);
                part.normals.push_back(normal);
                part.uvs.emplace_back((1 + s) / 2, (1 - t) / 2);
            }
            if (side > 0) {
                part.triangles.push_back({first, first + 1, first + 3});
                part.triangles.push_back({first, first + 3, first + 2});
            } else {
                part.triangles.push_back({first, first + 3, first + 1});
                part.triangles.push_back({first, first + 2, first + 3});
            }
        }
    }
}

void add_lathe(Part& part, const std::vector<ProfilePoint>& profile, int segments, double repeat) {
    const auto first = static_cast<std::uint32_t>(part.points.size());
    const auto columns = static_cast<std::uint32_t>(segments + 1);
    const double low = profile.front().height, high = profile.back().height;
    for (const ProfilePoint& p : profile) {
        const double length = std::hypot(p.normal_radius, p.normal_height);
        for (int i = 0; i <= segments; ++i) {
            const double turn = 2 * std::numbers::pi * (i % segments) / segments;
            const double c = std::cos(turn), s = std::sin(turn);
            part.points.emplace_back(p.radius * c, p.height, p.radius * s);
            part.normals.emplace_back(
                Vec3d(p.normal_radius * c, p.normal_height, p.normal_radius * s) / length);
            part.uvs.emplace_back(repeat * i / segments,
                                  high > low ? (high - p.height) / (high - low) : 0);
        }
    }
    for (std::size_t row = 0; row + 1 < profile.size(); ++row) {
        const ProfilePoint &lower = profile[row], &upper = profile[row + 1];
        if (lower.radius == upper.radius && lower.height == upper.height) continue;  // an edge
        for (std::uint32_t i = 0; i + 1 < columns; ++i) {
            const auto a = first + static_cast<std::uint32_t>(row) * columns + i;
            const std::uint32_t b = a + 1, c = a + columns, d = c + 1;
            if (lower.radius > 0) part.triangles.push_back({a, c, b});
            if (upper.radius > 0) part.triangles.push_back({b, c, d});
        }
    }
}

void add_frustum(Part& part, double bottom_radius, double top_radius, double bottom, double top,
                 int segments, double repeat) {
    const double slope = bottom_radius - top_radius, height = top - bottom;
    add_lathe(part,
              {{0, bottom, 0, -1},
               {bottom_radius, bottom, 0, -1},
               {bottom_radius, bottom, height, slope},
               {top_radius, top, height, slope},
               {top_radius, top, 0, 1},
               {0, top, 0, 1}},
              segments, repeat);
}

}  // namespace luch::assets
