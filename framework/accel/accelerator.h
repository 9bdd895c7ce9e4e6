#pragma once

#include "framework/accel/isa.h"
#include "framework/accel/packet.h"
#include "framework/math/ray.h"
#include "framework/scene/scene.h"

#include <cstdint>
#include <memory>
#include <span>

namespace luch {

/// Work that traversal did; depends on kernel and width: reported, never asserted.
struct WorkCounts {
    std::uint64_t boxes = 0;
    std::uint64_t primitives = 0;
    std::uint64_t searches = 0;  ///< for the nodes that a ray or a packet may meet

    WorkCounts& operator+=(const WorkCounts& other) {
        boxes += other.boxes;
        primitives += other.primitives;
        searches += other.searches;
        return *this;
    }
};

/// Finds what rays meet in one scene. Built once, then read by any number of threads. Techniques do
/// not call it: they shoot through a Tracer, which counts. A ray with a NaN, an infinite origin or
/// a zero direction misses.
class Accelerator {
 public:
    virtual ~Accelerator() = default;
    /// The nearest hit of a ray, by nearer(); no hit: Hit{}.
    virtual Hit closest(const Ray& ray, WorkCounts& work) const = 0;
    /// The nearest hit with one node only.
    virtual Hit closest_in(NodeId node, const Ray& ray, WorkCounts& work) const = 0;
    /// Whether anything at all is hit.
    virtual bool occluded(const Ray& ray, WorkCounts& work) const = 0;
    /// The same for a packet: hits of all its rays, in order; 1 where anything is hit, else 0.
    virtual void closest(const RayPacket& rays, HitPacket& hits, WorkCounts& work) const = 0;
    virtual void occluded(const RayPacket& rays, std::span<std::uint8_t> blocked,
                          WorkCounts& work) const = 0;
    /// Improves hits of a packet, by nearer(), with one node only.
    virtual void improve(NodeId node, const RayPacket& rays, HitPacket& hits,
                         WorkCounts& work) const = 0;
    /// Memory held, in bytes.
    virtual std::uint64_t bytes() const = 0;
};

/// What looks for the triangles of a mesh. Hits are those of intersect_triangle() either way; see
/// EmbreeMesh for what may differ.
enum class Backend { luch, embree };

/// "luch" or "embree". Throws Error for another word, and where this build has no Embree.
Backend parsed_backend(std::string_view text);

/// Binned-SAH BVHs over the triangles of every mesh, and one over the nodes. Keeps a reference to
/// the scene, which must outlive it. The hits are the same whatever the instructions. `skip` false:
/// a single node is searched for, too, and rays are turned into the coordinates even of nodes that
/// stand in the world's; the hits stay the same.
std::unique_ptr<Accelerator> build_accelerator(const Scene& scene, Isa isa = parsed_isa(""),
                                               Backend backend = Backend::luch, bool skip = true);

/// The oracle: tests every primitive of every node. Slow on purpose.
Hit closest_brute(const Scene& scene, const Ray& ray);

}  // namespace luch
