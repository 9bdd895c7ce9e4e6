#pragma once

#include "scenes/generator/teapot.h"

#include <vector>

namespace luch::assets {

/// A round hall of stone, in metres, its axis the y axis: a column with base and capital, 7 high;
/// the ring that lies on twelve of them, the dome over it, 8 in radius and open at the top; the
/// wall and the pavement behind and below them, 10.5 in radius. v runs downwards, on the pavement
/// from the middle out; u and v grow so that a texture repeats 24 by 5 times in the dome and 12
/// times around the wall.
std::vector<Surface> column();
std::vector<Surface> entablature();
std::vector<Surface> dome();
std::vector<Surface> wall();
std::vector<Surface> pavement();

}  // namespace luch::assets
