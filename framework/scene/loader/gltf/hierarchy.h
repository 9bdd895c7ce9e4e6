#pragma once

#include "framework/math/transform.h"
#include "framework/scene/loader/gltf/document.h"

#include <vector>

namespace luch::loader::gltf {

/// A mesh somewhere in the file's default scene.
struct Placed {
    Part mesh;
    Transform to_scene;  ///< into our left-handed coordinates: z mirrored
};

/// The meshes of the default scene, each with the product of its nodes' transforms, in double.
/// glTF is right-handed with y up; mirroring z makes it our left-handed world. Throws Error on a
/// node that is reached twice, nesting deeper than 256, and a singular transform.
std::vector<Placed> placed_meshes(const Document& document);

}  // namespace luch::loader::gltf
