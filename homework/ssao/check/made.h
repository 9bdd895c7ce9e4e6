#pragma once

#include "homework/ssao/check/samples.h"

// Pictures of planes, for what is known without a reference.
namespace luch::homework::ssao {

/// A plane in camera space: the points p with normal·p = offset, normal of unit length; only those
/// with x ≥ least_x.
struct FlatThing {
    Vec3d normal;
    double offset = 0;
    double least_x = -std::numeric_limits<double>::infinity();
};

/// What a camera sees of planes.
struct Made {
    explicit Made(const std::vector<FlatThing>& things, Size size = {48, 36});
    [[nodiscard]] GBuffer seen() const { return {position.view(), normal.view()}; }

    Screen screen;
    Image<float> depth;
    Image<Vec3> position, normal;
};

/// Facing the eye, at a depth.
FlatThing facing(double depth, double least_x = -std::numeric_limits<double>::infinity());
/// Through (0, 0, 10), turned by an angle from facing the eye, around an axis of the screen.
FlatThing tilted(double degrees, double around_degrees);
/// Two walls at a right angle; where they meet there is a line in the middle of the frame, at an
/// angle from upright.
std::vector<FlatThing> corner(double degrees);

}  // namespace luch::homework::ssao
