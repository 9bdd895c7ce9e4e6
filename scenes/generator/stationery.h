#pragma once

#include "scenes/generator/teapot.h"

#include <vector>

namespace luch::assets {

/// A pencil along y, in centimetres, its point at 0: body, wood and lead apart.
std::vector<Surface> pencil_body();
std::vector<Surface> pencil_wood();
std::vector<Surface> pencil_lead();

/// Both pages of an open book, 30 wide, 21 high, bulging towards −z beside the middle; the point
/// between the pages' lower ends is the origin. u from left to right, v from the top, as one
/// picture.
std::vector<Surface> open_book();

}  // namespace luch::assets
