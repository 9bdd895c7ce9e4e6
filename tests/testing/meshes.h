#pragma once

#include "framework/stress/made/meshes.h"

// Meshes made by hand, as tests call them.
namespace luch::testing {

using stress::awkward_point;
using stress::random_point;
using stress::triangle;
using stress::triangle_soup;
using stress::uv_sphere;

}  // namespace luch::testing
