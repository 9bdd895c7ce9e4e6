#pragma once

#include "framework/stress/made/scenes.h"

// Scenes made by hand, as tests call them.
namespace luch::testing {

using stress::add_shape;
using stress::different_pixels;
using stress::empty_scene;
using stress::mesh_of;
using stress::one_of_each;
using stress::one_triangle;
using stress::OwnStudio;
using stress::plane_of;
using stress::sixty_spheres;

}  // namespace luch::testing
