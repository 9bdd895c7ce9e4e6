#pragma once

#include "techniques/shadow_map/shadow_map.h"

namespace luch::techniques::shadow_map {

/// The distance from a light to the nearest surface by longitude and latitude, as the lecture draws
/// it: 4n × 2n texels, so that a texel at the equator is as wide as one in a cube map of n × n. Row
/// 0 is at the pole y = −1; column 0 begins at longitude −π, where z = −0 and x < 0.
struct SphereMap {
    int n = 0;
    Image<float> distance;
};

/// The unit direction through the centre of a texel.
Vec3 direction_in_sphere(int x, int y, int n);

/// A tile of the map, into distance(x − tile.x0, y − tile.y0), as Steps::render_face.
void render_sphere(const Vec3d& light, int n, Tile tile, Tracer& tracer, ImageView<float> distance);

/// Steps::bias for this map: half a texel's longitude and latitude times the gradients there, and
/// what D curves downwards near the poles.
void sphere_bias(std::span<const Receiver> receivers, int n, std::span<float> biases);

/// lit() and pcf(): past ±π the texels go round, past a pole they go on along the meridian.
void sphere_shares(const SphereMap& map, std::span<const Receiver> receivers,
                   std::span<const float> biases, bool pcf, std::span<float> shares);

}  // namespace luch::techniques::shadow_map
