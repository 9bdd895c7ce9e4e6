#pragma once

#include "scenes/generator/indexed_image.h"

namespace luch::assets {

/// All of them tile without a seam and depend on nothing but their size.

/// Four floor boards along x, each with a tone and a grain of its own and one joint.
IndexedImage boards(Size size);

/// White marble with grey veins.
IndexedImage marble(Size size);

/// Heights for a bump: rough plaster, grey.
IndexedImage plaster(Size size);

/// Heights for a bump: hammered metal, shallow round dents, grey.
IndexedImage hammered(Size size);

}  // namespace luch::assets
