#pragma once

#include "framework/accel/accelerator.h"
#include "framework/accel/hit.h"
#include "framework/accel/isa.h"
#include "framework/accel/packet.h"
#include "framework/accel/wide/split.h"
#include "framework/accel/wide/tree.h"
#include "framework/math/transform.h"

namespace luch::wide {

/// The rays of a packet as a shape sees them.
struct ShapeRays {
    const RayPacket* packet;
    const Transform* to_object;  ///< null: the shape stands as its geometry says
    Vec3d origin;                ///< in the shape's coordinates, as shape_ray() makes it
};

/// What they meet, as intersect() of shapes.h says: t is infinite where that is nothing.
struct ShapeHits {
    alignas(64) float t[RayPacket::capacity];
    alignas(64) std::uint32_t face[RayPacket::capacity];  ///< of no meaning where nothing is met
};

/// The searches through a tree, compiled for one level of the processor. All levels give the same
/// bits; see kernel.cpp.
struct Kernels {
    /// Improves `best`, by nearer(), with the triangles of a tree seen as `node`; true when it did.
    bool (*closest)(const Tree&, const ObjectRay&, NodeId node, Hit& best, WorkCounts&);
    /// Whether any triangle is hit.
    bool (*occluded)(const Tree&, const ObjectRay&, WorkCounts&);
    /// Calls leaf(context, number) for the leaves of a tree over boxes that a ray may meet before
    /// `limit`, near to far. It returns the limit from then on; −∞ ends the search. Boxes count as
    /// met within `slack` · (Σ|origin| + extent).
    void (*walk)(const Tree&, const ObjectRay&, float limit, float slack,
                 float (*leaf)(void* context, std::uint32_t number), void* context, WorkCounts&);
    /// closest() for the rays of a packet in world space, which `to_object` leads to the tree. In:
    /// hits.t is the limit of each ray, −∞ for those that look for nothing.
    void (*closest_packet)(const Tree&, const Transform& to_object, const RayPacket&, NodeId node,
                           HitPacket& hits, WorkCounts&);
    /// `limits` (of RayPacket::capacity, aligned to 64 bytes) becomes −∞ where a ray is blocked.
    void (*occluded_packet)(const Tree&, const Transform& to_object, const RayPacket&,
                            float* limits, WorkCounts&);
    void (*meet_plane)(const Plane&, const ShapeRays&, ShapeHits&);
    void (*meet_sphere)(const Sphere&, const ShapeRays&, ShapeHits&);
    void (*meet_cube)(const Cube&, const ShapeRays&, ShapeHits&);
    /// For the builder, see split_kernel.h: bounds of `count` refs; a range in two, neither empty.
    Range (*range_of)(const Ref* refs, std::uint32_t count);
    void (*split)(Ref* refs, const Range&, bool by_count, Range& left, Range& right);
};

// Those compiled for x86-64-v2, -v3 and -v4 exist on that processor only.
const Kernels& kernels_plain();
const Kernels& kernels_v2();
const Kernels& kernels_v3();
const Kernels& kernels_v4();

/// The kernels of a level that this processor can run.
const Kernels& kernels(Isa isa);

}  // namespace luch::wide
