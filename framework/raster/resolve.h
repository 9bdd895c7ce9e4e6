#pragma once

#include "framework/raster/set_up.h"

// From items to hits: the operations of intersect_triangle() in the same order, for sixteen pixels
// at once. Only kernel files include this; nothing here has linkage.
namespace luch::raster {
namespace {

/// Sixteen rays in a node's coordinates, and what they meet.
struct Group {
    Three<Sixteen> origin, direction, inverse;
    Three<Sixteen> p[3];
    Sixteen edge;
};

struct Found {
    Sixteen t, u, v;
    unsigned certain;
};

using Directions = float[3][RayPacket::capacity];

/// The same operations as Transform::direction and object_ray().
LUCH_INLINE void turn(const RayPacket& rays, const Transform& to_object, Directions& to) {
    for (int axis = 0; axis < 3; ++axis) {
        const double mx = to_object.matrix[axis][0], my = to_object.matrix[axis][1],
                     mz = to_object.matrix[axis][2];
        for (int i = 0; i < RayPacket::capacity; ++i) {
            to[axis][i] = static_cast<float>(rays.x[i] * mx + rays.y[i] * my + rays.z[i] * mz);
        }
    }
}

LUCH_INLINE void take_corners(const Triangle& triangle, Group& group) {
    for (int k = 0; k < 3; ++k) {
        const float* p = triangle.corner + 3 * k;
        group.p[k] = {p[0], p[1], p[2]};
    }
    group.edge = triangle.edge;
}

LUCH_INLINE void clip(const Sixteen& lo, const Sixteen& hi, const Sixteen& inverse, Sixteen& near,
                      Sixteen& far) {
    const unsigned negative = inverse < Sixteen(0.0f);
    near = max_or(Sixteen::select(negative, hi, lo) * inverse, near);
    far = min_or(Sixteen::select(negative, lo, hi) * inverse, far);
}

/// barycentric() in lanes.
LUCH_INLINE Sixteen share(const Sixteen& part, const Sixteen& whole, const Sixteen& limit) {
    const Sixteen ratio = part / whole;
    return Sixteen::select(Sixteen(0.0f) < ratio, min_or(limit, ratio), 0.0f);
}

LUCH_INLINE Found found_by(const Group& g) {
    Three<Sixteen> a[3];
    for (int k = 0; k < 3; ++k) a[k] = minus(g.p[k], g.origin);
    const Three<Sixteen> edge1 = minus(g.p[1], g.p[0]), edge2 = minus(g.p[2], g.p[0]);
    const Three<Sixteen> normal = cross(edge1, edge2);
    const Sixteen above = dot(normal, a[0]), along = dot(normal, g.direction);
    const Three<Sixteen> lo = wide::lower(a[0], wide::lower(a[1], a[2]));
    const Three<Sixteen> hi = wide::upper(a[0], wide::upper(a[1], a[2]));
    Sixteen near(-infinite), far(infinite);
    clip(lo.x, hi.x, g.inverse.x, near, far);
    clip(lo.y, hi.y, g.inverse.y, near, far);
    clip(lo.z, hi.z, g.inverse.z, near, far);
    far = max_or(far * Sixteen(far_padding), far);
    Found found;
    found.t = min_or(far, max_or(near, above / along));
    found.certain =
        (wide::sign_bound(g.edge, g.edge, wide::sum_of_sizes(a[0])) < abs(above)) &
        (wide::sign_bound(g.edge, g.edge, wide::sum_of_sizes(g.direction)) < abs(along)) &
        (near <= far) & (Sixteen(0.0f) < found.t) & (found.t < Sixteen(infinite));
    const Sixteen w0 = dot(cross(a[1], minus(a[2], a[1])), g.direction);
    const Sixteen w1 = dot(cross(a[2], minus(a[0], a[2])), g.direction);
    const Sixteen w2 = dot(cross(a[0], minus(a[1], a[0])), g.direction);
    const Sixteen whole = w0 + w1 + w2;
    found.u = share(w1, whole, 1.0f);
    found.v = share(w2, whole, Sixteen(1.0f) - found.u);
    return found;
}

/// The hit function itself, where the lanes are not certain of what it would say.
void hit_alone(const Target& target, std::uint32_t item, const Ray& ray, int i, HitPacket& hits) {
    const Triangle& triangle = target.triangles[item - target.base];
    TriangleHit hit;
    const bool found =
        intersect_triangle(object_ray(target.to_object->ray(ray)), triangle.point(0),
                           triangle.point(1), triangle.point(2), target.cull_backfaces, hit);
    hits.set(i, found ? Hit{hit.t, hit.u, hit.v, target.node, triangle.id} : Hit{});
}

/// A bit for each of sixteen items that `is` says yes to.
template <class Is>
LUCH_INLINE unsigned those(const std::uint32_t* items, Is&& is) {
    alignas(64) float yes[16];
    for (int i = 0; i < 16; ++i) yes[i] = is(items[i]) ? 1.0f : 0.0f;
    return Sixteen(0.5f) < Sixteen::load(yes);
}

/// Hits of sixteen pixels, triangle by triangle.
LUCH_INLINE void resolve_group(const Target& target, const std::uint32_t* items, unsigned rest,
                               Group& group, const RayPacket& rays, int first, HitPacket& hits) {
    Sixteen t = Sixteen::load(hits.t + first), u = Sixteen::load(hits.u + first),
            v = Sixteen::load(hits.v + first);
    unsigned doubtful = 0;
    while (rest != 0) {
        const std::uint32_t item = items[std::countr_zero(rest)];
        const Triangle& triangle = target.triangles[item - target.base];
        const unsigned same = those(items, [&](std::uint32_t other) { return other == item; });
        rest &= ~same;
        take_corners(triangle, group);
        const Found found = found_by(group);
        const unsigned set = found.certain & same;
        doubtful |= same & ~set;
        t = Sixteen::select(set, found.t, t);
        u = Sixteen::select(set, found.u, u);
        v = Sixteen::select(set, found.v, v);
        for (int i = 0; i < 16; ++i) {
            const bool here = items[i] == item;
            hits.node[first + i] = here ? target.node : hits.node[first + i];
            hits.primitive[first + i] = here ? triangle.id : hits.primitive[first + i];
        }
    }
    t.store(hits.t + first);
    u.store(hits.u + first);
    v.store(hits.v + first);
    for (; doubtful != 0; doubtful &= doubtful - 1) {
        const int i = std::countr_zero(doubtful);
        hit_alone(target, items[i], rays.ray(first + i), first + i, hits);
    }
}

void resolve(const Target& target, const std::uint32_t* items, const RayPacket& rays,
             HitPacket& hits) {
    alignas(64) Directions directions;
    turn(rays, *target.to_object, directions);
    Group group;
    const Vec3 origin(target.to_object->point(rays.origin));
    group.origin = {origin.x, origin.y, origin.z};
    const Sixteen one(1.0f);
    for (int first = 0; first < RayPacket::capacity; first += 16) {
        const unsigned ours = those(
            items + first, [&](std::uint32_t item) { return item - target.base < target.count; });
        if (ours == 0) continue;
        group.direction = {Sixteen::load(directions[0] + first),
                           Sixteen::load(directions[1] + first),
                           Sixteen::load(directions[2] + first)};
        group.inverse = {one / group.direction.x, one / group.direction.y, one / group.direction.z};
        resolve_group(target, items + first, ours, group, rays, first, hits);
    }
}

}  // namespace
}  // namespace luch::raster
