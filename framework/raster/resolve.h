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

LUCH_INLINE void turn(const RayPacket& rays, int first, const Transform& to_object,
                      float (*to)[16]) {
    for (int axis = 0; axis < 3; ++axis) {
        const double mx = to_object.matrix[axis][0], my = to_object.matrix[axis][1],
                     mz = to_object.matrix[axis][2];
        for (int i = 0; i < 16; ++i) {
            const int k = first + i;
            to[axis][i] = static_cast<float>(rays.x[k] * mx + rays.y[k] * my + rays.z[k] * mz);
        }
    }
}

/// The corners of one triangle for all lanes, or of one for each.
LUCH_INLINE void take_corners(const Triangle* triangles, const std::uint32_t (&which)[16],
                              Group& group) {
    unsigned other = 0;
    for (int i = 1; i < 16; ++i) other |= which[i] ^ which[0];
    const auto take = [&](auto&& number) {
        for (int k = 0; k < 3; ++k) {
            group.p[k] = {number(3 * k), number(3 * k + 1), number(3 * k + 2)};
        }
        group.edge = number(9);
    };
    if (other == 0) {
        const Triangle& triangle = triangles[which[0]];
        take([&](int i) { return Sixteen(i < 9 ? triangle.corner[i] : triangle.edge); });
        return;
    }
    alignas(64) float lanes[10][16];
    for (int lane = 0; lane < 16; ++lane) {
        const Triangle& triangle = triangles[which[lane]];
        for (int i = 0; i < 9; ++i) lanes[i][lane] = triangle.corner[i];
        lanes[9][lane] = triangle.edge;
    }
    take([&](int i) { return Sixteen::load(lanes[i]); });
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
void hit_alone(const Triangle& triangle, bool cull_backfaces, const Ray& ray, NodeId node, int i,
               HitPacket& hits) {
    TriangleHit hit;
    if (!intersect_triangle(object_ray(ray), triangle.point(0), triangle.point(1),
                            triangle.point(2), cull_backfaces, hit)) {
        return;
    }
    hits.set(i, {hit.t, hit.u, hit.v, node, triangle.id});
}

LUCH_INLINE void put(unsigned mask, const Sixteen& value, float* to) {
    Sixteen::select(mask, value, Sixteen::load(to)).store(to);
}

void resolve(const Triangle* triangles, std::uint32_t base, std::uint32_t count,
             bool cull_backfaces, const Transform& to_object, NodeId node,
             const std::uint32_t* items, const RayPacket& rays, int first, HitPacket& hits) {
    std::uint32_t which[16];
    unsigned ours = 0;
    for (int i = 0; i < 16; ++i) ours |= (items[i] - base < count ? 1u : 0u) << i;
    if (ours == 0) return;
    const std::uint32_t some = items[std::countr_zero(ours)] - base;
    for (int i = 0; i < 16; ++i) which[i] = items[i] - base < count ? items[i] - base : some;
    alignas(64) float directions[3][16];
    turn(rays, first, to_object, directions);
    Group group;
    const Vec3 origin(to_object.point(rays.origin));
    group.origin = {origin.x, origin.y, origin.z};
    group.direction = {Sixteen::load(directions[0]), Sixteen::load(directions[1]),
                       Sixteen::load(directions[2])};
    const Sixteen one(1.0f);
    group.inverse = {one / group.direction.x, one / group.direction.y, one / group.direction.z};
    take_corners(triangles, which, group);
    const Found found = found_by(group);
    const unsigned certain = found.certain & ours;
    put(certain, found.t, hits.t + first);
    put(certain, found.u, hits.u + first);
    put(certain, found.v, hits.v + first);
    for (int i = 0; i < 16; ++i) {
        const bool set = (certain >> i & 1) != 0;
        hits.node[first + i] = set ? node : hits.node[first + i];
        hits.primitive[first + i] = set ? triangles[which[i]].id : hits.primitive[first + i];
    }
    for (unsigned rest = ours & ~certain; rest != 0; rest &= rest - 1) {
        const int i = std::countr_zero(rest);
        hit_alone(triangles[which[i]], cull_backfaces, to_object.ray(rays.ray(first + i)), node,
                  first + i, hits);
    }
}

}  // namespace
}  // namespace luch::raster
