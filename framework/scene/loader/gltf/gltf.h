#pragma once

#include "framework/scene/loader/blocks.h"
#include "framework/scene/loader/mesh_builder.h"

namespace luch::loader {

/// Reads the triangles (strips and fans too) of the default scene of a glTF 2.0 file: positions,
/// normals and TEXCOORD_0, moved by the nodes' transforms and mirrored into our left-handed world.
/// Mesh::materials are indices into Loading::file_materials, where the file's own are added.
/// Skins, morph targets and animations, points and lines are passed over, with a warning.
/// Throws Error "file: part: what, and what to do".
Mesh read_gltf(const std::filesystem::path& file, const MeshOptions& options, Loading& loading);

}  // namespace luch::loader
