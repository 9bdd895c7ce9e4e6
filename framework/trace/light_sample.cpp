#include "framework/trace/light_sample.h"

namespace luch {
namespace {

/// Light from a place, of which `irradiance` and `highlight` arrive.
LightSample from_place(const Vec3d& place, const Rgb& irradiance, const Rgb& highlight,
                       const Surface& surface) {
    const Vec3d to_light = place - surface.position;
    const double distance = glm::length(to_light);
    return {distance > 0 ? to_light / distance : Vec3d(0), shadow_ray(surface, place), irradiance,
            highlight};
}

Rgb at_distance(const Rgb& color, double power, const Vec3d& way) {
    return color * static_cast<float>(power / glm::dot(way, way));
}

LightSample sample(const PointLight& light, int, Key, const Surface& surface) {
    const Vec3d way = surface.position - light.position;
    return from_place(light.position, at_distance(light.color, light.power, way), light.color,
                      surface);
}

LightSample sample(const SpotLight& light, int, Key, const Surface& surface) {
    const Vec3d way = surface.position - light.position;
    const auto share = static_cast<float>(light.falloff(glm::normalize(way)));
    return from_place(light.position, at_distance(light.color, light.power, way) * share,
                      light.color * share, surface);
}

LightSample sample(const DirectionalLight& light, int, Key, const Surface& surface) {
    return {-light.direction, leaving(surface, -light.direction), light.color * light.power,
            light.color};
}

LightSample sample(const RectLight& light, int cell, Key key, const Surface& surface) {
    const int column = cell % light.x_samples, row = cell / light.x_samples;
    const Vec2d inside = key.square(static_cast<std::uint64_t>(cell));
    const double x = (column + inside.x) / light.x_samples - 0.5;
    const double z = (row + inside.y) / light.y_samples - 0.5;
    const Vec3d facing = light.facing();
    // Lifted off the light's own visible face, which would block half of the rays by rounding.
    Vec3d place = light.to_world.point({x, 0, z});
    place += 0x1p-44 * (max_norm(place) + max_norm(light.to_world.matrix)) * facing;
    const Vec3d way = surface.position - place;
    const double cosine = std::max(0.0, glm::dot(facing, way) / glm::length(way));
    const float share = 1.0f / static_cast<float>(light.x_samples * light.y_samples);
    return from_place(place, at_distance(light.color, light.power * cosine, way) * share,
                      cosine > 0 ? light.color * share : Rgb(0), surface);
}

}  // namespace

int sample_count(const Light& light) {
    const auto* rect = std::get_if<RectLight>(&light);
    return rect ? rect->x_samples * rect->y_samples : 1;
}

bool stands_in_one_place(const Light& light) {
    return std::holds_alternative<PointLight>(light) || std::holds_alternative<SpotLight>(light);
}

LightSample sample_of(const Light& light, int index, Key key, const Surface& surface) {
    return std::visit([&](const auto& kind) { return sample(kind, index, key, surface); }, light);
}

}  // namespace luch
