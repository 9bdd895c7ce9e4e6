#pragma once

#include "framework/accel/accelerator.h"
#include "framework/accel/crossings.h"
#include "framework/accel/shapes.h"

namespace luch {

/// The nearest hit with t_min < t < t_max, as for the other shapes; from above and from below.
/// `work` counts the blocks that were looked at as boxes, and the cells that the ray was followed
/// through as primitives.
std::optional<ShapeHit> intersect(const Heightfield& field, const Ray& ray, WorkCounts& work);

/// Adds all crossings.
void find_crossings(const Heightfield& field, const Ray& ray, Crossings& crossings,
                    WorkCounts& work);

/// The height of the plane of a triangle of the field at (x, z).
double height_of(const Heightfield& field, const Heightfield::Triangle& triangle, double x,
                 double z);

/// Where a ray meets that plane. NaN or infinite where it is parallel to it.
double plane_t(const Heightfield& field, const Heightfield::Triangle& triangle, const Ray& ray);

}  // namespace luch
