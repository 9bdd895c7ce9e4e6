#include "scenes/generator/lathe.h"

#include <algorithm>
#include <numbers>

namespace luch::assets {
namespace {

/// The outside's direction at each point of a profile: the mean of its two segments'.
std::vector<Vec2d> normals_of(const Profile& profile) {
    std::vector<Vec2d> normals(profile.size(), Vec2d(0));
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const Vec2d way = glm::normalize(profile[i + 1] - profile[i]);
        normals[i] += Vec2d(way.y, -way.x);
        normals[i + 1] += Vec2d(way.y, -way.x);
    }
    for (Vec2d& normal : normals) normal = glm::normalize(normal);
    // On the axis a surface is level, or it would have a point there.
    for (std::size_t i = 0; i < profile.size(); ++i) {
        if (profile[i].x == 0) normals[i] = {0, normals[i].y < 0 ? -1 : 1};
    }
    return normals;
}

Surface turned(const Profile& profile, int sides) {
    const auto rows = static_cast<std::uint32_t>(profile.size());
    const auto columns = static_cast<std::uint32_t>(sides);
    const std::vector<Vec2d> normals = normals_of(profile);
    Surface surface{"lathe", {}, {}, {}, {}};
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column <= columns; ++column) {
            surface.uvs.push_back({double(column) / columns, double(row) / (rows - 1)});
            if (column == columns) continue;
            const double angle = 2 * std::numbers::pi * column / columns;
            const double c = std::cos(angle), s = std::sin(angle);
            surface.points.push_back({profile[row].x * c, profile[row].y, profile[row].x * s});
            surface.normals.push_back({normals[row].x * c, normals[row].y, normals[row].x * s});
        }
    }
    const auto corner = [&](std::uint32_t row, std::uint32_t column) {
        return Surface::Corner{row * columns + column % columns, row * (columns + 1) + column};
    };
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const auto a = corner(row, column), b = corner(row + 1, column);
            const auto c = corner(row + 1, column + 1), d = corner(row, column + 1);
            if (profile[row + 1].x != 0) surface.triangles.push_back({a, b, c});
            if (profile[row].x != 0) surface.triangles.push_back({a, c, d});
        }
    }
    return surface;
}

/// A quarter of an ellipse or any other part of one, angles in degrees from +radius to +height.
Profile arc(const Vec2d& centre, const Vec2d& radii, double from_deg, double to_deg, int steps) {
    Profile profile;
    for (int i = 0; i <= steps; ++i) {
        const double angle = (from_deg + (to_deg - from_deg) * i / steps) * std::numbers::pi / 180;
        profile.push_back(centre + radii * Vec2d(std::cos(angle), std::sin(angle)));
    }
    // The axis is met exactly.
    for (Vec2d& point : profile) {
        if (std::abs(point.x) < 1e-9) point.x = 0;
    }
    return profile;
}

Profile joined(std::vector<Profile> parts) {
    Profile profile;
    for (const Profile& part : parts) {
        for (const Vec2d& point : part) {
            if (profile.empty() || glm::distance(profile.back(), point) > 1e-6) {
                profile.push_back(point);
            }
        }
    }
    return profile;
}

Profile reversed(Profile profile) {
    std::reverse(profile.begin(), profile.end());
    return profile;
}

}  // namespace

std::vector<Surface> lathe(const std::vector<Profile>& pieces, int sides) {
    std::vector<Surface> surfaces;
    for (const Profile& piece : pieces) surfaces.push_back(turned(piece, sides));
    return surfaces;
}

std::vector<Surface> tumbler(int sides) {
    const Profile foot{{0, 0}, {3.4, 0}};
    const Profile outside = joined({arc({3.4, 0.4}, {0.4, 0.4}, -90, 0, 6), {{4.5, 11.9}}});
    const Profile rim = arc({4.4, 11.9}, {0.1, 0.1}, 0, 180, 8);
    const Profile inside =
        joined({{{4.3, 11.9}}, arc({2.9, 2.7}, {0.75, 0.9}, 0, -90, 8), {{0, 1.8}}});
    return lathe({foot, outside, rim, inside}, sides);
}

std::vector<Surface> tumbler_drink(int sides) {
    constexpr double gap = 0.02;
    const double top = 4.3 - (11.9 - 8.5) * (4.3 - 3.65) / (11.9 - 2.7) - gap;
    const Profile below = reversed(joined(
        {{{top, 8.5}}, arc({2.9, 2.7}, {0.75 - gap, 0.9 - gap}, 0, -90, 8), {{0, 1.8 + gap}}}));
    return lathe({below, {{top, 8.5}, {0, 8.5}}}, sides);
}

std::vector<Surface> wine_glass(int sides) {
    const Profile foot{{0, 0}, {3.5, 0}};
    // The bowl is part of an ellipse around (0, 13.5).
    const Profile outside =
        joined({arc({3.5, 0.12}, {0.12, 0.12}, -90, 60, 6),
                {{1.6, 0.5}, {0.6, 1.1}, {0.42, 2.5}, {0.4, 5}, {0.46, 7}, {0.8, 8}},
                arc({0, 13.5}, {4.2, 5.7}, -70, 49, 16)});
    const Profile inside = reversed(arc({0, 13.5}, {4.04, 5.2}, -90, 49, 18));
    const Profile rim{
        outside.back(), {(outside.back() + inside.front()) / 2.0 + Vec2d(0, 0.06)}, inside.front()};
    return lathe({foot, outside, rim, inside}, sides);
}

std::vector<Surface> wine(int sides) {
    constexpr double gap = 0.02;
    const Vec2d radii{4.04 - gap, 5.2 - gap};
    const double level = std::asin((13 - 13.5) / radii.y) * 180 / std::numbers::pi;
    const Profile below = arc({0, 13.5}, radii, -90, level, 14);
    return lathe({below, {below.back(), {0, below.back().y}}}, sides);
}

}  // namespace luch::assets
