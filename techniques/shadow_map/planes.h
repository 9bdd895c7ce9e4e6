#pragma once

#include "techniques/shadow_map/atlas.h"

namespace luch::techniques::shadow_map {

/// Draws the first map there is over the whole frame: the faces of a cube as a cross (+z, +x, −z,
/// −x side by side, y above and below), a sphere as it is. Near is bright, nothing is blue, what is
/// not stored is black.
void unwrap(const Atlas& atlas, ImageView<Rgb> colour);

}  // namespace luch::techniques::shadow_map
