#include "scenes/generator/masonry.h"

#include "scenes/generator/lathe.h"

#include <cmath>

namespace luch::assets {
namespace {

constexpr int around_column = 18, around_hall = 48;

Profile arc(const Vec2d& centre, double radius, double from_deg, double to_deg, int steps) {
    Profile points;
    for (int i = 0; i <= steps; ++i) {
        const double angle = (from_deg + (to_deg - from_deg) * i / steps) * M_PI / 180;
        points.push_back(centre + radius * Vec2d(std::cos(angle), std::sin(angle)));
    }
    return points;
}

/// A texture upright, and repeated.
std::vector<Surface> tiled(std::vector<Surface> surfaces, const Vec2d& times) {
    for (Surface& surface : surfaces) {
        for (Vec2d& uv : surface.uvs) uv = times * Vec2d(uv.x, 1 - uv.y);
    }
    return surfaces;
}

}  // namespace

std::vector<Surface> column() {
    // The shaft is a little thicker below: entasis.
    const std::vector<Profile> pieces{
        {{0.68, 0}, {0.68, 0.22}},
        {{0.68, 0.22}, {0.56, 0.22}},
        arc({0.52, 0.34}, 0.12, -80, 80, 6),
        {{0.47, 0.45}, {0.46, 2.2}, {0.44, 4}, {0.39, 6.2}},
        arc({0.39, 6.26}, 0.05, -80, 80, 4),
        {{0.39, 6.3}, {0.42, 6.45}, {0.52, 6.62}, {0.66, 6.72}},
        {{0.66, 6.72}, {0.66, 7}},
    };
    return tiled(lathe(pieces, around_column), {1, 1});
}

std::vector<Surface> entablature() {
    const std::vector<Profile> pieces{
        {{10.5, 7}, {7.45, 7}},
        {{7.45, 7}, {7.45, 7.5}},
        {{7.45, 7.5}, {7.55, 7.55}, {7.55, 7.95}},
        {{7.55, 7.95}, {7.3, 8.05}, {7.2, 8.2}, {7.25, 8.3}},
        {{7.25, 8.3}, {8.05, 8.3}},
    };
    return tiled(lathe(pieces, around_hall), {1, 1});
}

std::vector<Surface> dome() {
    const Profile vault = arc({0, 8.2}, 8, 0, 78, 15);
    return tiled(lathe({vault, {vault.back(), {1.62, 16.4}}}, around_hall), {24, 5});
}

std::vector<Surface> wall() {
    return tiled(lathe({{{10.5, 0}, {10.5, 7}}}, around_hall), {12, 1});
}

std::vector<Surface> pavement() {
    Profile disc;
    for (int i = 0; i <= 10; ++i) disc.push_back({10.5 * (10 - i) / 10, 0});
    return tiled(lathe({disc}, around_hall), {1, 1});
}

}  // namespace luch::assets
