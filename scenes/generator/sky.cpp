#include "scenes/generator/sky.h"

#include "framework/math/vec.h"
#include "scenes/generator/noise.h"

#include <algorithm>

namespace luch::assets {
namespace {

// From below the horizon over the glow to the zenith.
constexpr Byte3 colours[] = {{46, 40, 52},    {92, 66, 66},    {214, 128, 78},  {248, 190, 120},
                             {226, 178, 158}, {158, 150, 180}, {104, 124, 176}, {64, 92, 152},
                             {42, 64, 120},   {30, 46, 94}};

/// Where in the ramp a direction lies: its height, with a glow that reaches higher towards +z.
double height_in_ramp(const Vec3d& direction) {
    const Vec3d d = glm::normalize(direction);
    const double glow = 0.55 + 0.45 * d.z;
    const double above = d.y / (0.45 + 0.55 * glow);
    return d.y < 0 ? 0.2 + 0.6 * std::max(d.y, -1.0 / 3) : 0.2 + 0.8 * std::min(above, 1.0);
}

/// A direction for the side's coordinates s (right) and t (down), both −1..1: the inverse of the
/// scene format's table.
struct Side {
    const char* name;
    Vec3d middle, right, down;
};
const Side sides[] = {
    {"negx", {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, {"negy", {0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {"negz", {0, 0, -1}, {1, 0, 0}, {0, 1, 0}},  {"posx", {1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
    {"posy", {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {"posz", {0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
};

/// The six sides of the ramp values that `value` gives to directions.
template <class Value>
std::vector<std::pair<std::string, IndexedImage>> cube_map(int side_px,
                                                           std::span<const Byte3> stops,
                                                           Value&& value) {
    std::vector<std::pair<std::string, IndexedImage>> images;
    for (const Side& side : sides) {
        // The border pixels' centres lie on the cube's edges, so neighbours share their colours.
        const auto coordinate = [&](double centre) {
            return 2 * (centre * side_px - 0.5) / (side_px - 1) - 1;
        };
        images.emplace_back(
            side.name, painted({side_px, side_px}, stops, [&](double x, double y) {
                return value(side.middle + side.right * coordinate(x) + side.down * coordinate(y));
            }));
    }
    return images;
}

// From the zenith's blue over the horizon's haze to the clouds' white.
constexpr Byte3 day_colours[] = {{52, 104, 178},  {84, 138, 200},  {124, 170, 216},
                                 {170, 202, 230}, {204, 222, 236}, {226, 234, 240},
                                 {240, 243, 246}, {252, 252, 252}};

/// Clouds thin out towards the horizon, where haze takes over.
double day_value(const Vec3d& direction) {
    const Vec3d d = glm::normalize(direction);
    const double up = std::max(d.y, 0.0);
    const double haze = 0.62 * (1 - up) * (1 - up) * (1 - up);
    if (up == 0) return haze;
    const Vec2d on_layer = Vec2d(d.x, d.z) / (up + 0.12) * 0.06 + 0.5;
    const double cover = Noise(61).fractal(on_layer.x, on_layer.y, 6, 6, 6);
    const double cloud = std::clamp((cover - 0.50) / 0.22, 0.0, 1.0) * std::min(1.0, 6 * up);
    return haze + (0.97 - haze) * cloud * (0.8 + 0.2 * cloud);
}

}  // namespace

std::vector<std::pair<std::string, IndexedImage>> evening_sky(int side_px) {
    return cube_map(side_px, colours, height_in_ramp);
}

std::vector<std::pair<std::string, IndexedImage>> fair_sky(int side_px) {
    return cube_map(side_px, day_colours, day_value);
}

}  // namespace luch::assets
