#pragma once

#include "scenes/generator/assets.h"

namespace luch::assets {

/// The scene "forest": its models (.glb), and the scene that places them, some thousands of times.
std::vector<Asset> forest_files();

}  // namespace luch::assets
