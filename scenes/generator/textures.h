#pragma once

#include "scenes/generator/indexed_image.h"

namespace luch::assets {

/// All but the landscape tile without a seam.

/// Four floor boards along x, each with a tone and a grain of its own and one joint.
IndexedImage boards(Size size);

/// White marble with grey veins.
IndexedImage marble(Size size);

/// Heights for a bump: rough plaster, grey.
IndexedImage plaster(Size size);

/// Heights for a bump: hammered metal, shallow round dents, grey.
IndexedImage hammered(Size size);

/// A picture to hang on a wall: hills before an evening sun.
IndexedImage landscape(Size size);

}  // namespace luch::assets
