#pragma once

#include "framework/accel/wide/kernels.h"

namespace luch {

/// What the rays of a packet meet of a plane, sphere or cube: the bits of intersect() for each ray
/// that is_sound(), many at once. False, and nothing done, for another geometry. `to_object` null:
/// the geometry stands as it says.
bool meet(const Geometry& geometry, const Transform* to_object, const RayPacket& rays,
          const wide::Kernels& kernels, wide::ShapeHits& hits);

}  // namespace luch
