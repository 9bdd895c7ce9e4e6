#pragma once

#include "framework/scene/scene.h"

namespace luch::stress {

/// Adds a geometry with a material of its own, as a node.
NodeId add(Scene& scene, Geometry geometry, Material material,
           const Transform& to_world = Transform());

/// Every kind of shape, material, texture and light once or more, with mirrors, meshes and sheared
/// and mirrored transforms; 64 × 48 pixels.
Scene bit_of_everything();

}  // namespace luch::stress
