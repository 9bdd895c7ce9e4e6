#pragma once

#include "framework/math/rng.h"
#include "framework/scene/geometry.h"

namespace luch::testing {

/// A closed sphere of triangles around the origin: rings × segments, poles included.
Mesh uv_sphere(int rings, int segments, double radius);

/// Triangles with corners anywhere in a cube of half-side 1.
Mesh triangle_soup(int count, double size, Key key);

/// One triangle.
Mesh triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c);

}  // namespace luch::testing
