#include "framework/accel/embree_mesh.h"

#include "framework/accel/embree_tree.h"
#include "framework/accel/node_hit.h"

#include <embree3/rtcore.h>

namespace luch {
namespace {

constexpr int width = 16;
/// Embree squares coordinates, and takes |components| of directions below 1e-18 for that.
constexpr float largest_coordinate = 0x1p40f;
constexpr float infinite = std::numeric_limits<float>::infinity();

bool takes(const Mesh& mesh) {
    for (const Vec3& p : mesh.positions) {
        if (!(max_norm(p) < largest_coordinate)) return false;
    }
    return !mesh.triangles.empty();
}

/// A ray whose direction was scaled by a power of two, to a size that Embree is made for.
struct Asked {
    Vec3 direction;
    float t_min, t_max;
};

/// Nothing for rays that Embree may take otherwise than we do.
std::optional<Asked> asked(const ObjectRay& ray, float limit) {
    const float size = max_norm(ray.direction);
    if (!(max_norm(ray.origin) < largest_coordinate && size > 0x1p-60f && size < 0x1p60f)) {
        return std::nullopt;
    }
    if (!all_finite(ray.direction) || !(ray.t_min >= 0) || !(limit > ray.t_min)) {
        return std::nullopt;
    }
    int exponent = 0;
    std::frexp(size, &exponent);
    return Asked{ray.direction * std::ldexp(1.0f, -exponent), std::ldexp(ray.t_min, exponent),
                 std::ldexp(limit, exponent)};
}

/// The same, with room at both ends for Embree's rounding of a hit that may count.
std::optional<Asked> asked_with_room(const ObjectRay& ray, float limit) {
    auto result = asked(ray, limit);
    if (!result) return result;
    result->t_min *= 1 - 0x1p-16f;
    result->t_max *= 1 + 0x1p-16f;
    return result;
}

template <class Rays>
void put(Rays& rays, int i, const Vec3& origin, const Asked& ray) {
    rays.org_x[i] = origin.x;
    rays.org_y[i] = origin.y;
    rays.org_z[i] = origin.z;
    rays.dir_x[i] = ray.direction.x;
    rays.dir_y[i] = ray.direction.y;
    rays.dir_z[i] = ray.direction.z;
    rays.tnear[i] = ray.t_min;
    rays.tfar[i] = ray.t_max;
    rays.time[i] = 0;
    rays.mask[i] = ~0u;
    rays.flags[i] = 0;
}

RTCRay one_ray(const Vec3& o, const Asked& ray) {
    const Vec3& d = ray.direction;
    return {o.x, o.y, o.z, ray.t_min, d.x, d.y, d.z, 0, ray.t_max, ~0u, 0, 0};
}

RTCIntersectContext context_of(RTCIntersectContextFlags flags) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = flags;
    return context;
}

/// Sixteen rays of a packet in a mesh's frame, as far as they look for something.
struct Sixteen {
    ObjectRay ray[width];
    alignas(64) int valid[width];

    /// Calls one(lane, ray) for each; those that it says true for are for Embree.
    template <class One>
    bool gather(const RayPacket& rays, int first, const Node& seen_as, const float* limits,
                One&& one) {
        bool any = false;
        for (int i = 0; i < width; ++i) {
            valid[i] = 0;
            if (first + i >= rays.count || limits[first + i] == -infinite) continue;
            const Ray world = rays.ray(first + i);
            if (!is_sound(world)) continue;
            ray[i] = object_ray(to_object(world, seen_as));
            valid[i] = one(i, ray[i]) ? -1 : 0;
            any |= valid[i] != 0;
        }
        return any;
    }
};

}  // namespace

EmbreeMesh::EmbreeMesh(const Mesh& mesh, Isa isa) : mesh_(&mesh), own_(mesh, isa) {
    if (takes(mesh)) tree_ = std::make_unique<EmbreeTree>(mesh, 1.0f, true, isa);
}
EmbreeMesh::EmbreeMesh(EmbreeMesh&&) noexcept = default;
EmbreeMesh::~EmbreeMesh() = default;

std::uint64_t EmbreeMesh::bytes() const {
    return own_.bytes() + (tree_ ? tree_->bytes() : 0);
}

bool EmbreeMesh::settle(std::uint32_t triangle, const ObjectRay& ray, NodeId node, Hit& best,
                        WorkCounts& work) const {
    ++work.primitives;
    return improve(ray, mesh_->corner(triangle, 0), mesh_->corner(triangle, 1),
                   mesh_->corner(triangle, 2), mesh_->cull_backfaces, node, triangle, best) ||
           own_.closest(ray, node, best, work);
}

bool EmbreeMesh::closest(const ObjectRay& ray, NodeId node, Hit& best, WorkCounts& work) const {
    const auto ask = tree_ ? asked_with_room(ray, best.t) : std::nullopt;
    if (!ask) return own_.closest(ray, node, best, work);
    RTCRayHit found{.ray = one_ray(ray.origin, *ask), .hit = {}};
    found.hit.geomID = found.hit.primID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    rtcIntersect1(tree_->scene(), &context, &found);
    return found.hit.geomID != RTC_INVALID_GEOMETRY_ID &&
           settle(found.hit.primID, ray, node, best, work);
}

bool EmbreeMesh::occluded(const ObjectRay& ray, WorkCounts& work) const {
    const bool either_side = tree_ && !mesh_->cull_backfaces;
    const auto ask = either_side ? asked(ray, ray.t_max) : std::nullopt;
    if (!ask) return own_.occluded(ray, work);
    RTCRay found = one_ray(ray.origin, *ask);
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    rtcOccluded1(tree_->scene(), &context, &found);
    return found.tfar == -infinite;
}

void EmbreeMesh::closest(const RayPacket& rays, const Node& seen_as, NodeId node, HitPacket& hits,
                         WorkCounts& work) const {
    if (!tree_) return own_.closest(rays, seen_as, node, hits, work);
    for (int first = 0; first < rays.count; first += width) {
        Sixteen group;
        RTCRayHit16 found;
        const auto improve_alone = [&](int i, auto&& search) {
            Hit best = hits.hit(first + i);
            if (search(best)) hits.set(first + i, best);
        };
        const auto add = [&](int i, const ObjectRay& ray) {
            const auto ask = asked_with_room(ray, hits.t[first + i]);
            if (ask) {
                put(found.ray, i, ray.origin, *ask);
            } else {
                improve_alone(i, [&](Hit& best) { return own_.closest(ray, node, best, work); });
            }
            found.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            return ask.has_value();
        };
        if (!group.gather(rays, first, seen_as, hits.t, add)) continue;
        RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
        rtcIntersect16(group.valid, tree_->scene(), &context, &found);
        for (int i = 0; i < width; ++i) {
            if (group.valid[i] == 0 || found.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
            improve_alone(i, [&](Hit& best) {
                return settle(found.hit.primID[i], group.ray[i], node, best, work);
            });
        }
    }
}

void EmbreeMesh::occluded(const RayPacket& rays, const Node& seen_as, float* limits,
                          WorkCounts& work) const {
    if (!tree_ || mesh_->cull_backfaces) return own_.occluded(rays, seen_as, limits, work);
    for (int first = 0; first < rays.count; first += width) {
        Sixteen group;
        RTCRay16 found;
        const auto add = [&](int i, const ObjectRay& ray) {
            const auto ask = asked(ray, ray.t_max);
            if (ask) {
                put(found, i, ray.origin, *ask);
            } else if (own_.occluded(ray, work)) {
                limits[first + i] = -infinite;
            }
            return ask.has_value();
        };
        if (!group.gather(rays, first, seen_as, limits, add)) continue;
        RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
        rtcOccluded16(group.valid, tree_->scene(), &context, &found);
        for (int i = 0; i < width; ++i) {
            const bool blocked = group.valid[i] != 0 && found.tfar[i] == -infinite;
            if (blocked) limits[first + i] = -infinite;
        }
    }
}

}  // namespace luch
