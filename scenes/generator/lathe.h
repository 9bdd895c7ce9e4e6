#pragma once

#include "scenes/generator/teapot.h"

#include <span>
#include <vector>

namespace luch::assets {

/// A profile turned around the y axis: points (radius ≥ 0, height), smooth along their way. Running
/// upwards at a radius, it looks outwards.
struct Profile {
    std::string_view name;
    std::vector<Vec2d> points;
    Vec2d tiles{1, 1};  ///< how often a texture repeats around, and along
};

/// One surface a profile, `segments` around. u runs around from 0 to tiles.x, v along the profile
/// by its length from tiles.y to 0.
std::vector<Surface> turned(std::span<const Profile> profiles, int segments);

/// Made of round stone, in metres: a column with base and capital, 7 high; the ring that lies on
/// twelve of them; the dome over it, 8 in radius, open at the top; wall and floor.
std::vector<Surface> column();
std::vector<Surface> entablature();
std::vector<Surface> dome();
std::vector<Surface> wall();
std::vector<Surface> pavement();

/// A pencil along y, in centimetres, its point at 0: body, wood and lead apart.
std::vector<Surface> pencil_body();
std::vector<Surface> pencil_wood();
std::vector<Surface> pencil_lead();

/// Both pages of an open book, 30 wide, 21 high, bulging towards −z beside the middle; the point
/// between the pages' lower ends is the origin. u from left to right, v from the top, as one
/// picture.
std::vector<Surface> open_book();

}  // namespace luch::assets
