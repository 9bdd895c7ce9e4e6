#include "techniques/shadow_map/planes.h"

#include "techniques/shadow_map/cube.h"

namespace luch::techniques::shadow_map {
namespace {

/// What a place of the picture shows: a distance, or none (nothing there), or not stored.
struct Sample {
    bool stored = false;
    float distance = 0;
};

/// A direction on an unwrapped cube, four faces wide and three high; zero beside the cross.
Vec3 on_cross(double across, double down) {
    const int column = std::min(static_cast<int>(across * 4), 3);
    const int row = std::min(static_cast<int>(down * 3), 2);
    const double u = 2 * (across * 4 - column) - 1, v = 1 - 2 * (down * 3 - row);
    if (row != 1 && column != 0) return Vec3(0);
    if (row == 0) return {u, 1, -v};
    if (row == 2) return {u, -1, v};
    const Vec3d sides[] = {{u, v, 1}, {1, v, -u}, {-u, v, -1}, {-1, v, u}};
    return Vec3(sides[column]);
}

Sample on_cube(const CubeMap& map, double across, double down) {
    const Vec3 d = on_cross(across, down);
    if (d == Vec3(0)) return {};
    Texel texel;
    reference().texel_of({&d, 1}, map.n, {&texel, 1});
    const Tile& window = map.faces[static_cast<std::size_t>(texel.face)].window;
    const bool stored =
        texel.x >= window.x0 && texel.x < window.x1 && texel.y >= window.y0 && texel.y < window.y1;
    return {stored, map.at(texel)};
}

Sample on_sphere(const SphereMap& map, double across, double down) {
    const auto place = [](double share, int n) {
        return std::clamp(static_cast<int>(share * n), 0, n - 1);
    };
    return {true, map.distance(place(across, map.distance.width()),
                               place(1 - down, map.distance.height()))};
}

}  // namespace

void unwrap(const Atlas& atlas, ImageView<Rgb> colour) {
    const Lamp* lamp = nullptr;
    for (const Lights& lights : atlas.lights()) {
        if (!lights.lamps.empty()) lamp = &lights.lamps[0];
        if (lamp != nullptr) break;
    }
    Image<Sample> samples(colour.size());
    float nearest = std::numeric_limits<float>::infinity();
    for (int y = 0; lamp != nullptr && y < colour.height(); ++y) {
        for (int x = 0; x < colour.width(); ++x) {
            const double across = (x + 0.5) / colour.width(), down = (y + 0.5) / colour.height();
            samples(x, y) = lamp->sphere.n > 0 ? on_sphere(lamp->sphere, across, down)
                                               : on_cube(lamp->map, across, down);
            if (samples(x, y).stored) nearest = std::min(nearest, samples(x, y).distance);
        }
    }
    for (int y = 0; y < colour.height(); ++y) {
        for (int x = 0; x < colour.width(); ++x) {
            const auto& [stored, distance] = samples(x, y);
            const bool nothing = std::isinf(distance);
            colour(x, y) = !stored   ? Rgb(0)
                           : nothing ? Rgb(0.02f, 0.04f, 0.2f)
                                     : Rgb(nearest / std::max(distance, nearest));
        }
    }
}

}  // namespace luch::techniques::shadow_map
