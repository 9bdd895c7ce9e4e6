#pragma once

#include "scenes/generator/indexed_image.h"

#include <string>

namespace luch::assets {

/// The bytes of an 8-bit PNG file with a palette, its pixels stored without compression, so that
/// they are the same with every version of every library.
std::string png_bytes(const IndexedImage& image);

}  // namespace luch::assets
