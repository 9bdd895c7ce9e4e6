#pragma once

#include "framework/math/ray.h"
#include "framework/scene/geometry.h"

namespace luch {

/// What a shape knows of a point of its own, in its own coordinates. Lengths need not be 1.
struct LocalSurface {
    Vec3d position;
    Vec3d geometric_normal;
    Vec3d normal;
    double extent = 1;  ///< no coordinate of the shape is larger, as far as it matters here
    double unit_roundoff = 0x1p-53;  ///< 2⁻²⁴ where rays are traced in float
};

/// The surface of a geometry at a hit; `ray` in its coordinates. `smooth`: the normal is
/// interpolated where the shape has some at its corners; else it is the geometric one.
LocalSurface local_surface(const std::vector<Geometry>& geometries, GeometryId geometry,
                           const Ray& ray, const Hit& hit, bool smooth);

/// The texture coordinates there.
Vec2d local_uv(const std::vector<Geometry>& geometries, GeometryId geometry,
               const LocalSurface& surface, const Hit& hit);

/// ∂P/∂u, ∂P/∂v; zero where the shape has none.
struct Tangents {
    Vec3d u{0}, v{0};
};
Tangents local_tangents(const Geometry& geometry, const Hit& hit);

}  // namespace luch
