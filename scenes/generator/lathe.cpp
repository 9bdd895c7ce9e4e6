#include "scenes/generator/lathe.h"

#include <algorithm>
#include <cmath>

namespace luch::assets {
namespace {

/// Of each point: across the mean of the two legs' directions.
std::vector<Vec2d> normals_of(const std::vector<Vec2d>& points) {
    std::vector<Vec2d> normals;
    for (std::size_t i = 0; i < points.size(); ++i) {
        Vec2d way(0);
        if (i > 0) way += glm::normalize(points[i] - points[i - 1]);
        if (i + 1 < points.size()) way += glm::normalize(points[i + 1] - points[i]);
        normals.push_back(glm::normalize(Vec2d(way.y, -way.x)));
    }
    return normals;
}

/// Of each point: how far along the profile it lies, 0..1.
std::vector<double> lengths_of(const std::vector<Vec2d>& points) {
    std::vector<double> lengths{0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        lengths.push_back(lengths.back() + glm::distance(points[i - 1], points[i]));
    }
    for (double& length : lengths) length /= lengths.back();
    return lengths;
}

/// The triangles of a sheet of rows × columns points with as many uvs; one that has no area is left
/// out.
void add_triangles(Surface& surface, std::uint32_t rows, std::uint32_t columns) {
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto &p = surface.points[a], &q = surface.points[b], &r = surface.points[c];
        if (glm::length(glm::cross(q - p, r - p)) < 1e-9) return;
        surface.triangles.push_back({{{a, a}, {b, b}, {c, c}}});
    };
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t a = row * columns + column, b = a + 1, c = a + columns;
            add(a, c, c + 1);
            add(a, c + 1, b);
        }
    }
}

Surface turned(const Profile& profile, int segments) {
    Surface surface{profile.name, {}, {}, {}, {}};
    const auto normals = normals_of(profile.points);
    const auto lengths = lengths_of(profile.points);
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        for (int k = 0; k <= segments; ++k) {
            const double turn = 2 * M_PI * (k % segments) / segments;
            const Vec3d out(std::cos(turn), 0, std::sin(turn));
            surface.points.push_back(out * profile.points[i].x + Vec3d(0, profile.points[i].y, 0));
            surface.normals.push_back(out * normals[i].x + Vec3d(0, normals[i].y, 0));
            surface.uvs.push_back(profile.tiles * Vec2d(double(k) / segments, 1 - lengths[i]));
        }
    }
    add_triangles(surface, static_cast<std::uint32_t>(profile.points.size()),
                  static_cast<std::uint32_t>(segments) + 1);
    return surface;
}

/// Points of an arc around a centre, by angles in degrees from the horizontal.
std::vector<Vec2d> arc(const Vec2d& centre, double radius, double from, double to, int steps) {
    std::vector<Vec2d> points;
    for (int i = 0; i <= steps; ++i) {
        const double angle = (from + (to - from) * i / steps) * M_PI / 180;
        points.push_back(centre + radius * Vec2d(std::cos(angle), std::sin(angle)));
    }
    return points;
}

constexpr int around_column = 18, around_hall = 48;

}  // namespace

std::vector<Surface> turned(std::span<const Profile> profiles, int segments) {
    std::vector<Surface> surfaces;
    for (const Profile& profile : profiles) surfaces.push_back(turned(profile, segments));
    return surfaces;
}

std::vector<Surface> column() {
    // The shaft is a little thicker below: entasis.
    const Profile profiles[] = {
        {"plinth", {{0.68, 0}, {0.68, 0.22}}},
        {"step", {{0.68, 0.22}, {0.56, 0.22}}},
        {"torus", arc({0.52, 0.34}, 0.12, -80, 80, 6)},
        {"shaft", {{0.47, 0.45}, {0.46, 2.2}, {0.44, 4}, {0.39, 6.2}}},
        {"collar", arc({0.39, 6.26}, 0.05, -80, 80, 4)},
        {"capital", {{0.39, 6.3}, {0.42, 6.45}, {0.52, 6.62}, {0.66, 6.72}}},
        {"abacus", {{0.66, 6.72}, {0.66, 7}}},
    };
    return turned(profiles, around_column);
}

std::vector<Surface> entablature() {
    const Profile profiles[] = {
        {"soffit", {{10.5, 7}, {7.45, 7}}},
        {"architrave", {{7.45, 7}, {7.45, 7.5}}},
        {"frieze", {{7.45, 7.5}, {7.55, 7.55}, {7.55, 7.95}}},
        {"cornice", {{7.55, 7.95}, {7.3, 8.05}, {7.2, 8.2}, {7.25, 8.3}}},
        {"top", {{7.25, 8.3}, {8.05, 8.3}}},
    };
    return turned(profiles, around_hall);
}

std::vector<Surface> dome() {
    const Profile profiles[] = {
        {"vault", arc({0, 8.2}, 8, 0, 78, 15), {24, 5}},
        {"rim", {{1.6633, 16.0252}, {1.62, 16.4}}},
    };
    return turned(profiles, around_hall);
}

std::vector<Surface> wall() {
    const Profile profiles[] = {{"wall", {{10.5, 0}, {10.5, 7}}, {12, 1}}};
    return turned(profiles, around_hall);
}

std::vector<Surface> pavement() {
    Profile disc{"pavement", {}, {1, 1}};
    for (int i = 0; i <= 10; ++i) disc.points.push_back({10.5 * (10 - i) / 10, 0});
    const Profile profiles[] = {disc};
    return turned(profiles, around_hall);
}

std::vector<Surface> pencil_body() {
    const Profile profiles[] = {{"body", {{0.38, 2.2}, {0.38, 17.5}}},
                                {"end", {{0.38, 17.5}, {0, 17.5}}}};
    return turned(profiles, 6);
}

std::vector<Surface> pencil_wood() {
    const Profile profiles[] = {{"wood", {{0.12, 0.7}, {0.37, 2.2}}}};
    return turned(profiles, 24);
}

std::vector<Surface> pencil_lead() {
    const Profile profiles[] = {{"lead", {{0, 0}, {0.12, 0.7}}}};
    return turned(profiles, 24);
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
    add_triangles(surface, 2, columns + 1);
    return {surface};
}

}  // namespace luch::assets
