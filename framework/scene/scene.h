#pragma once

#include "framework/scene/camera.h"
#include "framework/scene/environment.h"
#include "framework/scene/geometry.h"
#include "framework/scene/light.h"
#include "framework/scene/material.h"
#include "framework/scene/settings.h"
#include "framework/scene/texture.h"

#include <optional>
#include <string>
#include <vector>

namespace luch {

/// A geometry somewhere in the world, with a material. The visible faces of rect lights are nodes
/// too.
struct Node {
    std::string name;
    GeometryId geometry = 0;
    MaterialId material = 0;  ///< may be materials_of_file: ask material_of()
    TextureId bump = no_texture;
    bool moving = false;  ///< said by the scene, for techniques that keep what stands still
    Transform to_world;   ///< from the geometry's coordinates (a mesh's own frame included)
    Transform to_object;  ///< its inverse
};

/// All that a scene file says; immutable once loaded. The parts refer to one another by index.
struct Scene {
    std::string name;
    Settings settings;
    Camera camera;
    std::vector<Geometry> geometries;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Light> lights;
    std::optional<Environment> environment;
    std::vector<Node> nodes;  ///< only what is drawn; a NodeId is an index into this
};

/// Adds a node; `file_to_world` is what the scene file says, the mesh's own frame is put before it.
/// Throws std::domain_error when the transform is singular.
NodeId add_node(Scene& scene, std::string name, GeometryId geometry, MaterialId material,
                const Transform& file_to_world, TextureId bump = no_texture);

/// Adds a rect light and the node that is its visible face.
void add_rect_light(Scene& scene, std::string name, const RectLight& light);

/// The material of what a ray met: the node's, or that of the triangle in the mesh's file. The only
/// way to find it.
const Material& material_of(const Scene& scene, const Hit& hit);

/// Light that the sky sends from a direction: the environment's, else the background colour.
Rgb sky_radiance(const Scene& scene, const Vec3d& direction);

}  // namespace luch
