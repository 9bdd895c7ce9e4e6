#pragma once

#include "framework/scene/loader/assets.h"
#include "framework/scene/loader/names.h"
#include "framework/scene/scene.h"

#include <string>
#include <vector>

/// One function a class of block; each adds what it reads to the scene. Geometries, textures and
/// shaders are read before all others, so their indices are those of the NameTable; the textures
/// and materials that come with a mesh's file stand behind the named ones.
namespace luch::loader {

/// A scene half-way.
struct Loading {
    Diagnostics& diagnostics;
    Assets assets;
    NameTable names;
    Scene scene;
    std::vector<int> material_lines;           ///< of Scene::materials
    std::string settings_class, camera_class;  ///< of the block that counts; "" while there is none
    struct Solid {
        GeometryId geometry;
        int line;
    };
    std::vector<Solid> solids;  ///< in the order of Scene::geometries
    /// What mesh files bring; Mesh::materials are indices into it until all shaders are read.
    std::vector<Material> file_materials;
};

// settings.cpp
void read_settings(Properties& block, Loading& loading);
void read_camera(Properties& block, Loading& loading);
/// A camera of the older dialects.
void read_spherical_lens_camera(Properties& block, Loading& loading);
void read_fisheye_camera(Properties& block, Loading& loading);
void read_spherical_camera(Properties& block, Loading& loading);
void read_orthographic_camera(Properties& block, Loading& loading);

// textures.cpp
void read_checker(Properties& block, Loading& loading);
void read_bitmap(Properties& block, Loading& loading);
void read_bump(Properties& block, Loading& loading);
void read_bumps(Properties& block, Loading& loading);
void read_fresnel(Properties& block, Loading& loading);

// environments.cpp
void read_cubemap(Properties& block, Loading& loading);
void read_constant_environment(Properties& block, Loading& loading);

// geometries.cpp
void read_plane(Properties& block, Loading& loading);
void read_sphere(Properties& block, Loading& loading);
void read_cube(Properties& block, Loading& loading);
void read_mesh(Properties& block, Loading& loading);
/// Puts the materials of meshes' files behind the named ones. Call it once, after all shaders.
void add_file_materials(Loading& loading);
void read_heightfield(Properties& block, Loading& loading);

// solids.cpp
void read_union(Properties& block, Loading& loading);
void read_intersection(Properties& block, Loading& loading);
void read_difference(Properties& block, Loading& loading);
/// Unfolds all solids, once all geometries are read. Throws Error when one contains itself, is
/// nested deeper than 256, or unfolds to more parts than Csg allows.
void unfold_solids(Loading& loading);

// materials.cpp
void read_lambert(Properties& block, Loading& loading);
void read_phong(Properties& block, Loading& loading);
void read_reflection(Properties& block, Loading& loading);
void read_refraction(Properties& block, Loading& loading);
void read_layered(Properties& block, Loading& loading);
void read_const(Properties& block, Loading& loading);
/// Throws Error when layers contain themselves, are nested deeper than 256, or unfold to more than
/// 4,096 shaders.
void check_layers(const Loading& loading);

// lights.cpp
void read_point_light(Properties& block, Loading& loading);
void read_spot_light(Properties& block, Loading& loading);
void read_directional_light(Properties& block, Loading& loading);
void read_rect_light(Properties& block, Loading& loading);

// nodes.cpp
void read_node(Properties& block, Loading& loading);
/// The lines scale, rotate and translate. Throws Error when they flatten anything.
Transform transform_of(Properties& block);
/// Throws Error when the scene has as many nodes as it may.
void check_count(Properties& block, const Loading& loading);

}  // namespace luch::loader
