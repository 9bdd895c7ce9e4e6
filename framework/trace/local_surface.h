#pragma once

#include "framework/math/ray.h"
#include "framework/scene/geometry.h"

namespace luch {

/// What a shape knows of a point of its own, in its own coordinates. Lengths need not be 1.
struct LocalSurface {
    Vec3d position;
    Vec3d geometric_normal;
    Vec3d normal;
    Vec2d uv{0};
    Vec3d tangent_u{0}, tangent_v{0};  ///< ∂P/∂u, ∂P/∂v; zero where the shape has none
    double extent = 1;  ///< no coordinate of the shape is larger, as far as it matters here
    double unit_roundoff = 0x1p-53;  ///< 2⁻²⁴ where rays are traced in float
};

/// The surface of a geometry at a hit; `ray` in its coordinates.
LocalSurface local_surface(const std::vector<Geometry>& geometries, GeometryId geometry,
                           const Ray& ray, const Hit& hit);

}  // namespace luch
