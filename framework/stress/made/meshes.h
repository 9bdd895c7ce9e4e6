#pragma once

#include "framework/math/rng.h"
#include "framework/scene/scene.h"

namespace luch::stress {

/// A closed sphere of triangles around the origin: rings × segments, poles included.
Mesh uv_sphere(int rings, int segments, double radius);

/// Triangles with corners anywhere in a cube of half-side 1.
Mesh triangle_soup(int count, double size, Key key);

/// One triangle.
Mesh triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// A point of the cube from −size to size on every axis.
Vec3d random_point(Key key, double size);

/// A point of a scene that rays like to go wrong at: a corner or an edge of a mesh's triangle, or a
/// point about another shape's centre.
Vec3d awkward_point(const Scene& scene, Key key);

}  // namespace luch::stress
