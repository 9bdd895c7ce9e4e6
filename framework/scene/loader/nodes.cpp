#include "framework/scene/loader/blocks.h"

#include <fmt/format.h>

#include <cfloat>
#include <numbers>
#include <stdexcept>

namespace luch::loader {
namespace {

bool invertible(const Transform& transform) {
    try {
        return all_finite(transform.inverse().offset);
    } catch (const std::domain_error&) {
        return false;
    }
}

/// The lines act in the order in which they stand: scale and rotate multiply the matrix from the
/// right, translate adds to the offset, which is neither rotated nor scaled.
Transform transform_of(Properties& block) {
    constexpr double radians = std::numbers::pi / 180;
    Transform transform;
    for (const Property* line : block.lines({"scale", "rotate", "translate"})) {
        const Vec3d value = block.vector(*line);
        if (line->name == "translate") {
            transform.offset += value;
        } else if (line->name == "scale") {
            transform.matrix = transform.matrix * Transform::scaling(value).matrix;
        } else {
            const Vec3d angles = value * radians;
            transform.matrix =
                transform.matrix * Transform::rotation(angles.x, angles.y, angles.z).matrix;
        }
        if (!invertible(transform)) {
            block.diagnostics().fail(line->line,
                                     fmt::format("{} {} makes the transform singular; choose "
                                                 "numbers that flatten nothing",
                                                 line->name, shown(line->value)));
        }
    }
    return transform;
}

TextureId bump_of(Properties& block, const Loading& loading) {
    const Property* property = block.find("bump");
    if (!property) return no_texture;
    const TextureId id = loading.names.find(Kind::texture, block, *property);
    if (!std::holds_alternative<BumpTexture>(loading.scene.textures[id])) {
        block.diagnostics().fail(
            property->line,
            fmt::format("{} is no BumpTexture; choose one for bump", shown(block.text(*property))));
    }
    return id;
}

void check_count(Properties& block, const Loading& loading) {
    constexpr std::size_t most = 1000000;
    if (loading.scene.nodes.size() >= most) {
        block.diagnostics().fail(block.block().line,
                                 "the scene has more than 1,000,000 nodes; use fewer");
    }
}

float power_of(Properties& block) {
    return static_cast<float>(block.number("power", 1));
}

}  // namespace

void read_point_light(Properties& block, Loading& loading) {
    PointLight light;
    light.position = block.vector("pos", light.position);
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

void read_node(Properties& block, Loading& loading) {
    const GeometryId geometry =
        loading.names.find(Kind::geometry, block, block.required("geometry"));
    const Property* shader = block.find("shader");
    const TextureId bump = bump_of(block, loading);
    const Transform to_world = transform_of(block);
    const auto* mesh = std::get_if<Mesh>(&loading.scene.geometries[geometry]);
    if (!shader && (!mesh || mesh->materials.empty())) return;

    const MaterialId material =
        shader ? loading.names.find(Kind::shader, block, *shader) : materials_of_file;
    check_count(block, loading);
    try {
        add_node(loading.scene, block.block().name, geometry, material, to_world, bump);
    } catch (const std::domain_error&) {
        block.diagnostics().fail(block.block().line,
                                 fmt::format("{} has a singular transform; choose numbers that "
                                             "flatten nothing",
                                             block.title()));
    }
}

}  // namespace luch::loader
