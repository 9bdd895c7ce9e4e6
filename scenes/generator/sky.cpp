#include "scenes/generator/sky.h"

#include "framework/math/vec.h"

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

}  // namespace

std::vector<std::pair<std::string, IndexedImage>> evening_sky(int side_px) {
    std::vector<std::pair<std::string, IndexedImage>> images;
    for (const Side& side : sides) {
        // The border pixels' centres lie on the cube's edges, so neighbours share their colours.
        const auto coordinate = [&](double centre) {
            return 2 * (centre * side_px - 0.5) / (side_px - 1) - 1;
        };
        images.emplace_back(side.name,
                            painted({side_px, side_px}, colours, [&](double x, double y) {
                                return height_in_ramp(side.middle + side.right * coordinate(x) +
                                                      side.down * coordinate(y));
                            }));
    }
    return images;
}

}  // namespace luch::assets
