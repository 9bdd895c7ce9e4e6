// The students' kit: no reference steps, but something in their place while they are not written,
// so that the others can be seen at work: a map without a surface, a fiftieth of the distance for a
// bias, light everywhere, one point for a light with an area.
#include "techniques/shadow_map/shadow_map.h"

#include <algorithm>

namespace luch::techniques::shadow_map {
namespace {

void texel_of(std::span<const Vec3>, int n, std::span<Texel> texels) {
    std::ranges::fill(texels, Texel{0, n / 2, n / 2});
}

void direction_of(std::span<const Texel>, int, std::span<Vec3> directions) {
    std::ranges::fill(directions, Vec3(0, -1, 0));
}

void render_face(const Vec3d&, int, int, Tile, Tracer&, ImageView<float> distance) {
    std::fill_n(distance.data(), distance.size().area(), std::numeric_limits<float>::infinity());
}

void bias(std::span<const Receiver> receivers, int, std::span<float> biases) {
    std::ranges::transform(receivers, biases.begin(), [](const Receiver& receiver) {
        return 0.02f * glm::length(receiver.from_light);
    });
}

void all_lit(const CubeMap&, std::span<const Receiver>, std::span<const float>,
             std::span<float> shares) {
    std::ranges::fill(shares, 1.0f);
}

void light_points(const RectLight& light, int, Pattern, Key, std::vector<LightPoint>& points) {
    points = {{lifted_off(light, 0, 0), 1}};
}

}  // namespace

Steps reference() {
    return {texel_of, direction_of, render_face, bias, all_lit, all_lit, light_points};
}

/// No step: it is given.
Vec3d lifted_off(const RectLight& light, double x, double z) {
    const Vec3d on_face = light.to_world.point({x, 0, z});
    const double size = max_norm(on_face) + max_norm(light.to_world.matrix);
    return on_face + 0x1p-44 * size * light.facing();
}

}  // namespace luch::techniques::shadow_map
