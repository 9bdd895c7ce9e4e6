#include "framework/scene/scene.h"

namespace luch {

NodeId add_node(Scene& scene, std::string name, GeometryId geometry, MaterialId material,
                const Transform& file_to_world, TextureId bump) {
    Transform to_world = file_to_world;
    if (const auto* mesh = std::get_if<Mesh>(&scene.geometries[geometry])) {
        to_world = mesh->from_frame.then(file_to_world);
    }
    scene.nodes.push_back(
        {std::move(name), geometry, material, bump, false, to_world, to_world.inverse()});
    return static_cast<NodeId>(scene.nodes.size() - 1);
}

void add_rect_light(Scene& scene, std::string name, const RectLight& light) {
    const Vec3d x = light.to_world.direction({1, 0, 0});
    const Vec3d z = light.to_world.direction({0, 0, 1});
    const auto area = static_cast<float>(glm::length(glm::cross(x, z)));
    scene.lights.emplace_back(light);
    scene.geometries.emplace_back(Plane{.y = 0, .limit = 0.5});
    scene.materials.emplace_back(Emission{light.color * (light.power / area)});
    add_node(scene, std::move(name), static_cast<GeometryId>(scene.geometries.size() - 1),
             static_cast<MaterialId>(scene.materials.size() - 1), light.to_world);
}

const Material& material_of(const Scene& scene, const Hit& hit) {
    const Node& node = scene.nodes[hit.node];
    if (node.material != materials_of_file) return scene.materials[node.material];
    const auto& mesh = std::get<Mesh>(scene.geometries[node.geometry]);
    return scene.materials[mesh.materials[hit.primitive]];
}

Rgb sky_radiance(const Scene& scene, const Vec3d& direction) {
    if (!scene.environment) return scene.settings.background;
    return std::visit([&](const auto& sky) { return sky.radiance(direction); }, *scene.environment);
}

}  // namespace luch
