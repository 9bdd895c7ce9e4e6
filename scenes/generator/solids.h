#pragma once

#include "scenes/generator/model.h"

namespace luch::assets {

/// A point of a profile that is turned about the y axis, and the outward normal there (radius and
/// height parts). An edge is two points of one place.
struct ProfilePoint {
    double radius, height;
    double normal_radius, normal_height;
};

/// A box around `centre` with the given half-sides, with normals; each face shows the whole
/// picture.
void add_box(Part& part, const Vec3d& centre, const Vec3d& half);

/// A surface of revolution about the y axis, from the lowest profile point to the highest; u runs
/// around `repeat` times, v from the top down once.
void add_lathe(Part& part, const std::vector<ProfilePoint>& profile, int segments,
               double repeat = 1);

/// A cylinder or cone frustum about the y axis with flat ends.
void add_frustum(Part& part, double bottom_radius, double top_radius, double bottom, double top,
                 int segments, double repeat = 1);

}  // namespace luch::assets
