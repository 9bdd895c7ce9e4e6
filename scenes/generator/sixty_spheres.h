#pragma once

#include "framework/math/vec.h"

#include <string>
#include <vector>

namespace luch::assets {

struct Ball {
    Vec3d centre;
    double radius;
    int colour;  ///< which of the scene's materials, from 0
};

/// Sixty balls that do not touch, two in three of them lying on the floor y = 0; largest first.
std::vector<Ball> sixty_balls();

/// The whole scene file "sixty spheres".
std::string sixty_spheres_scene();

}  // namespace luch::assets
