#pragma once

#include "framework/math/ray.h"
#include "framework/scene/scene.h"
#include "framework/trace/counts.h"

namespace luch {

/// A point of a surface, in world space.
struct Surface {
    Vec3d position;
    Vec3d geometric_normal;  ///< of the true surface, unit length, turned against the ray
    Vec3d normal;  ///< for shading: interpolated and bumped, unit length, turned against the ray
    Vec2d uv{0};
    NodeId node = no_node;
    bool front = false;  ///< seen from the side that the shape's own geometric normal points to
    /// A length in world units: moved so far along the geometric normal, to either side, the point
    /// is certainly off the surface for a ray that starts there, whatever rounding did.
    double error = 0;
    /// The same for a ray that comes from elsewhere, for each unit of its length.
    double error_per_distance = 0;
};

/// The surface at a hit, with what is needed of it; counts each part that was at work.
Surface surface_at(const Scene& scene, const Ray& ray, const Hit& hit, const Needs& needs,
                   Counts& counts);
/// With all there is.
Surface surface_at(const Scene& scene, const Ray& ray, const Hit& hit);

/// The ray that leaves a surface point in a direction; its origin is moved off the surface, to the
/// side that the direction points to.
Ray leaving(const Surface& surface, const Vec3d& direction);

/// The ray from a light's point to a surface point (just above it, seen from the light): 0 < t < 1.
/// A shadow ray always runs this way.
Ray shadow_ray(const Surface& surface, const Vec3d& light_point);

}  // namespace luch
