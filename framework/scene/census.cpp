#include "framework/scene/census.h"

#include <algorithm>

namespace luch {
namespace {

/// Counts materials, each once, and those that its layers name.
class Materials {
 public:
    Materials(const Scene& scene, Census& census)
        : scene_(scene),
          census_(census),
          seen_(scene.materials.size()),
          seen_files_(scene.geometries.size()) {}

    /// Those that a node shows.
    void add(const Node& node) {
        if (node.material != materials_of_file) return add(node.material);
        if (seen_files_[node.geometry]) return;  // a forest's nodes share a few large meshes
        seen_files_[node.geometry] = true;
        for (const MaterialId id : std::get<Mesh>(scene_.geometries[node.geometry]).materials) {
            add(id);
        }
    }

 private:
    void add(MaterialId first) {
        std::vector<MaterialId> rest{first};
        while (!rest.empty()) {
            const MaterialId id = rest.back();
            rest.pop_back();
            if (seen_[id]) continue;
            seen_[id] = true;
            std::visit([&](const auto& material) { count(material, rest); }, scene_.materials[id]);
        }
    }

    void count(const Lambert& material, std::vector<MaterialId>&) {
        ++census_.lit;
        census_.textured += material.texture != no_texture;
    }
    void count(const Phong& material, std::vector<MaterialId>&) {
        ++census_.lit;
        census_.textured += material.texture != no_texture;
    }
    void count(const Reflection& material, std::vector<MaterialId>&) {
        census_.mirrors += material.multiplier != Rgb(0);
    }
    void count(const Refraction& material, std::vector<MaterialId>&) {
        census_.clear += material.multiplier != Rgb(0);
    }
    void count(const Layered& material, std::vector<MaterialId>& rest) {
        ++census_.layered;
        census_.textured += std::ranges::any_of(
            material.layers, [](const auto& layer) { return layer.texture != no_texture; });
        for (const auto& layer : material.layers) rest.push_back(layer.material);
    }
    void count(const Const&, std::vector<MaterialId>&) {}
    void count(const Emission&, std::vector<MaterialId>&) { ++census_.glowing; }

    const Scene& scene_;
    Census& census_;
    std::vector<bool> seen_, seen_files_;  ///< by material, and by geometry
};

bool is_moved(const Node& node) {
    return node.to_world.matrix != glm::dmat3(1) || node.to_world.offset != Vec3d(0);
}

bool is_smooth(const Geometry& geometry) {
    const auto* mesh = std::get_if<Mesh>(&geometry);
    return mesh != nullptr ? !mesh->normals.empty() && !mesh->faceted
                           : std::holds_alternative<Heightfield>(geometry);
}

/// Whether a geometry, or a part of a solid, is smooth.
bool shows_smooth(const Scene& scene, const Geometry& geometry) {
    const auto* solid = std::get_if<Csg>(&geometry);
    if (solid == nullptr) return is_smooth(geometry);
    return std::ranges::any_of(
        solid->parts, [&](const auto& part) { return is_smooth(scene.geometries[part.geometry]); });
}

void count(const Light& light, Census& census) {
    if (std::holds_alternative<RectLight>(light)) {
        ++census.area_lights;
    } else if (std::holds_alternative<DirectionalLight>(light)) {
        ++census.distant_lights;
    } else {
        ++census.standing_lights;
    }
}

}  // namespace

Census census_of(const Scene& scene) {
    Census census;
    Materials materials(scene, census);
    for (const Node& node : scene.nodes) {
        const Geometry& geometry = scene.geometries[node.geometry];
        ++census.nodes;
        census.moved += is_moved(node);
        census.bumps += node.bump != no_texture;
        census.smooth += shows_smooth(scene, geometry);
        census.solids += std::holds_alternative<Csg>(geometry);
        census.heightfields += std::holds_alternative<Heightfield>(geometry);
        materials.add(node);
    }
    for (const Light& light : scene.lights) count(light, census);
    return census;
}

}  // namespace luch
