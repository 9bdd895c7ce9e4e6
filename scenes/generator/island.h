#pragma once

#include "scenes/generator/indexed_image.h"

namespace luch::assets {

/// Heights of an island with a ridge, a bay and some rocks before it; 0 is the deepest sea. Grey.
IndexedImage island_heights(Size size);

/// The height at which that island's beaches begin, of 0..1.
inline constexpr double island_sea_level = 0.2;

/// Its colours, sRGB: sand, grass, woods, rock and snow, by height and steepness.
IndexedImage island_colours(Size size);

}  // namespace luch::assets
