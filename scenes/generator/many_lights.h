#pragma once

#include <string>

namespace luch::assets {

/// The scene "many lights": a thousand lanterns in a spiral, each a point light of its own colour.
std::string many_lights_scene();

}  // namespace luch::assets
