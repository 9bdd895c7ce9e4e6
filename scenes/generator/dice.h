#pragma once

#include <string>

namespace luch::assets {

/// The whole scene file "die".
std::string dice_scene();

}  // namespace luch::assets
