#include "framework/scene/loader/blocks.h"

#include <fmt/format.h>

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

TextureId bump_of(Properties& block, const Loading& loading) {
    const Property* property = block.find("bump");
    if (!property) return no_texture;
    const TextureId id = loading.names.find(Kind::texture, block, *property);
    if (!is_bump(loading.scene.textures[id])) {
        block.diagnostics().fail(property->line,
                                 fmt::format("{} is no bump; choose a BumpTexture or Bumps",
                                             shown(block.text(*property))));
    }
    return id;
}

}  // namespace

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

void check_count(Properties& block, const Loading& loading) {
    constexpr std::size_t most = 1000000;
    if (loading.scene.nodes.size() >= most) {
        block.diagnostics().fail(block.block().line,
                                 "the scene has more than 1,000,000 nodes; use fewer");
    }
}

void read_node(Properties& block, Loading& loading) {
    const GeometryId geometry =
        loading.names.find(Kind::geometry, block, block.required("geometry"));
    const Property* shader = block.find("shader");
    const TextureId bump = bump_of(block, loading);
    const Transform to_world = transform_of(block);
    const bool moving = block.flag("moving", !block.flag("static", true));
    const auto* mesh = std::get_if<Mesh>(&loading.scene.geometries[geometry]);
    if (!shader && (!mesh || mesh->materials.empty())) return;

    const MaterialId material =
        shader ? loading.names.find(Kind::shader, block, *shader) : materials_of_file;
    check_count(block, loading);
    try {
        add_node(loading.scene, block.block().name, geometry, material, to_world, bump);
        loading.scene.nodes.back().moving = moving;
    } catch (const std::domain_error&) {
        block.diagnostics().fail(block.block().line,
                                 fmt::format("{} has a singular transform; choose numbers that "
                                             "flatten nothing",
                                             block.title()));
    }
}

}  // namespace luch::loader
