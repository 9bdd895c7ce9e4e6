#include "framework/scene/loader/blocks.h"

#include <fmt/format.h>

#include <cfloat>
#include <numbers>

namespace luch::loader {
namespace {

float power_of(Properties& block) {
    return static_cast<float>(block.number("power", 1));
}

/// A direction of unit length.
Vec3d direction_of(Properties& block, Names names, const Vec3d& fallback) {
    const Property* property = block.find(names);
    if (!property) return fallback;
    const Vec3d direction = block.vector(*property);
    if (direction == Vec3d(0)) {
        block.diagnostics().fail(property->line,
                                 fmt::format("{} is (0, 0, 0), which points nowhere; choose "
                                             "another",
                                             property->name));
    }
    return glm::normalize(direction / max_norm(direction));
}

}  // namespace

void read_point_light(Properties& block, Loading& loading) {
    PointLight light;
    light.position = block.vector("pos", light.position);
    light.color = block.color("color", light.color);
    light.power = power_of(block);
    loading.scene.lights.emplace_back(light);
}

void read_spot_light(Properties& block, Loading& loading) {
    constexpr Range half_angles{0, 180};
    SpotLight light;
    light.position = block.required_vector("pos");
    light.direction = direction_of(block, "direction", light.direction);
    const double outer = block.number("outerAngle", 30, half_angles);
    const double inner = block.number("innerAngle", std::min(20.0, outer), half_angles);
    if (inner > outer) {
        block.diagnostics().fail(block.block().line,
                                 fmt::format("{} has an innerAngle of {} and an outerAngle of {}; "
                                             "the outer one is the larger of the two",
                                             block.title(), inner, outer));
    }
    light.inner_cosine = std::cos(inner * std::numbers::pi / 180);
    light.outer_cosine = std::cos(outer * std::numbers::pi / 180);
    light.color = block.color("color", light.color);
    light.power = power_of(block);
    loading.scene.lights.emplace_back(light);
}

void read_directional_light(Properties& block, Loading& loading) {
    DirectionalLight light;
    light.direction = direction_of(block, "direction", light.direction);
    light.color = block.color("color", light.color);
    light.power = power_of(block);
    loading.scene.lights.emplace_back(light);
}

void read_rect_light(Properties& block, Loading& loading) {
    constexpr Range cells{1, 1000};
    RectLight light;
    light.color = block.color("color", light.color);
    light.power = power_of(block);
    light.x_samples = block.integer("xSubd", light.x_samples, cells);
    light.y_samples = block.integer("ySubd", light.y_samples, cells);
    light.to_world = transform_of(block);

    check_count(block, loading);
    const double area = glm::length(
        glm::cross(light.to_world.direction({1, 0, 0}), light.to_world.direction({0, 0, 1})));
    if (!(area >= FLT_MIN && area <= FLT_MAX && std::abs(light.power) / area <= FLT_MAX)) {
        block.diagnostics().fail(block.block().line,
                                 fmt::format("{} has an area of {}; scale it so that power / area "
                                             "is a number of single precision",
                                             block.title(), area));
    }
    add_rect_light(loading.scene, block.block().name, light);
}

}  // namespace luch::loader
