#pragma once

#include "scenes/generator/indexed_image.h"

#include <string>
#include <utility>
#include <vector>

namespace luch::assets {

/// An evening sky for a CubemapEnvironment: its six sides under the names that the scene format
/// asks for ("negx" …), sRGB. The glow lies towards +z.
std::vector<std::pair<std::string, IndexedImage>> evening_sky(int side_px);

/// The same for a fair day: haze at the horizon, blue above, and white clouds in a flat layer.
std::vector<std::pair<std::string, IndexedImage>> fair_sky(int side_px);

}  // namespace luch::assets
