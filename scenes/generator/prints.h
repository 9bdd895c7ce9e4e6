#pragma once

#include "scenes/generator/indexed_image.h"

namespace luch::assets {

/// Two printed pages beside each other: on the left a star of rays, which get finer towards the
/// middle (a test of sharpness), on the right a column of lines like text, and a row of discs.
IndexedImage printed_pages(Size size);

/// One coffer of a vault: a square hollow in three steps, light from above. Tiles.
IndexedImage coffer(Size size);

/// A painted panel between two columns. Tiles from left to right.
IndexedImage panel(Size size);

/// A pavement in polar coordinates, x around, y from the middle: rhombi between two families of
/// spirals, and a medallion.
IndexedImage spirals(Size size);

}  // namespace luch::assets
