#pragma once

#include "scenes/generator/teapot.h"

#include <vector>

namespace luch::assets {

/// A smooth piece of a profile: points (radius, height), the outside to the right of the way.
using Profile = std::vector<Vec2d>;

/// A surface of revolution around the y axis, cut into `sides` (≥ 3). Each piece is smooth, between
/// pieces are creases; pieces that follow one another from axis to axis make a closed body.
/// u runs around, v along the piece.
std::vector<Surface> lathe(const std::vector<Profile>& pieces, int sides);

/// A tumbler 12 high with a thick foot, standing on y = 0.
std::vector<Surface> tumbler(int sides);
/// What fills the tumbler up to y = 8.5: a hair's breadth of air between the two.
std::vector<Surface> tumbler_drink(int sides);
/// A wine glass 18 high on a thin stem, standing on y = 0.
std::vector<Surface> wine_glass(int sides);
/// What fills the wine glass up to y = 13.
std::vector<Surface> wine(int sides);

}  // namespace luch::assets
