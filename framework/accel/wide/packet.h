#pragma once

#include "framework/accel/wide/bundle.h"
#include "framework/accel/wide/single.h"

// 256 rays of one origin through the tree. A node's eight boxes are tested against the whole
// bundle, a child's box against its sixteen groups at once, a triangle against the groups' cones
// (both in lanes), and only then against rays, sixteen at a time. Only kernel files include this;
// nothing here has linkage.
namespace luch::wide {
namespace {

/// The range of near and far that a box's sides give for one axis.
struct Sides {
    float first, last;
};

LUCH_INLINE Sides sides(const Node& node, int slot, int axis, bool negative, float origin) {
    const float lo = node.bounds[2 * axis][slot] - origin;
    const float hi = node.bounds[2 * axis + 1][slot] - origin;
    return negative ? Sides{hi, lo} : Sides{lo, hi};
}

/// A bit for every group that may meet a child's box before its limit.
LUCH_INLINE unsigned groups_meeting(const Bundle& bundle, const Node& node, int slot) {
    Sixteen in(bundle.t_min), out(infinite);
    for (int axis = 0; axis < 3; ++axis) {
        const Ranges& inverse = bundle.inverses[axis];
        const Sides s = sides(node, slot, axis, bundle.negative[axis], bundle.origin[axis]);
        const Sixteen lo = Sixteen::load(inverse.lo), hi = Sixteen::load(inverse.hi);
        if (bundle.coherent) {
            in = max_or(Sixteen(s.first) * (s.first < 0 ? hi : lo), in);
            out = min_or(Sixteen(s.last) * (s.last < 0 ? lo : hi), out);
        } else {
            const unsigned turned = Sixteen::load(bundle.sign[axis]) < Sixteen(0.0f);
            const unsigned swapped = bundle.negative[axis] ? ~turned : turned;
            const Sixteen first = Sixteen::select(swapped, s.last, s.first);
            const Sixteen last = Sixteen::select(swapped, s.first, s.last);
            in = max_or(min_or(first * lo, first * hi), in);
            out = min_or(max_or(last * lo, last * hi), out);
        }
    }
    out = min_or(max_or(out * Sixteen(far_padding), out), Sixteen::load(bundle.limit));
    return in <= out;
}

/// A bit for every child that some ray of the bundle may meet; near: not before this t.
LUCH_INLINE unsigned children_meeting(const Bundle& bundle, const Node& node, float* near) {
    Eight in(bundle.t_min), out(infinite);
    for (int axis = 0; axis < 3; ++axis) {
        const Ranges& inverse = bundle.inverses[axis];
        const Eight lo(inverse.lo_all), hi(inverse.hi_all), origin(bundle.origin[axis]);
        const int side = 2 * axis + (bundle.negative[axis] ? 1 : 0);
        const Eight first = Eight::load(node.bounds[side]) - origin;
        const Eight last = Eight::load(node.bounds[side ^ 1]) - origin;
        in = max_or(min_or(first * lo, first * hi), in);
        out = min_or(max_or(last * lo, last * hi), out);
    }
    out = min_or(max_or(out * Eight(far_padding), out), Eight(bundle.limit_all));
    in.store(near);
    return (in <= out) & node.used;
}

/// The four triangles of a block as seen from the bundle's origin, lane by lane.
struct Facets {
    alignas(16) float edge[3][3][block_width];  ///< a × b of each edge, by components
    alignas(16) float normal[3][block_width];
    alignas(16) float above[block_width];                      ///< normal · a0
    alignas(16) float lo[3][block_width], hi[3][block_width];  ///< the triangle's box − origin
    alignas(16) float ray_bound[block_width];    ///< see sign_bound(), for edges and any ray
    alignas(16) float slope_bound[block_width];  ///< the same for normal · direction
    alignas(16) float cone_bound[block_width];   ///< the same for edges and any (u, v, 1)
    unsigned above_certain;
    unsigned front, back;  ///< every ray of the cone has a positive, negative sum of edge values
    unsigned alive;        ///< no edge has the whole cone outside
};

template <class T>
LUCH_INLINE T cone_upper(const T& nu, const T& nv, const T& nw, const T& u0, const T& u1,
                         const T& v0, const T& v1) {
    return max_or(nu * u0, nu * u1) + max_or(nv * v0, nv * v1) + nw;
}

LUCH_INLINE void store(const Three<Four>& from, float (*to)[block_width]) {
    from.x.store(to[0]);
    from.y.store(to[1]);
    from.z.store(to[2]);
}

/// Which triangles the whole cone passes by. A ray has hit only when no two edge values have
/// opposite signs; where their sum, normal · direction, is positive by more than its error, one of
/// them is, so an edge that is negative by more than its error for the whole cone rules it out.
/// The sum's error: corners rounded by u·A give edges off by 4uA, the cross product by
/// 24uAE + 32u²A², its product with (u, v, 1) by at most 40uAE + 32u²A² times cone_sum.
LUCH_INLINE void cull(const Bundle& bundle, const Four& size, const Four& edge_size, Facets& f) {
    f.front = f.back = 0;
    f.alive = 0xf;
    if (bundle.main < 0) return;
    const int a = bundle.main, b = (a + 1) % 3, c = (a + 2) % 3;
    const Four u0(bundle.u.lo_all), u1(bundle.u.hi_all), v0(bundle.v.lo_all), v1(bundle.v.hi_all);
    const Four sum(bundle.cone_sum);
    const Four bound = sign_bound(size, edge_size, sum);
    bound.store(f.cone_bound);
    const Four sum_bound = Four(0x1p-18f) * size * (edge_size + Four(0x1p-20f) * size) * sum +
                           Four(smallest_bound) * (sum + Four(1.0f));
    const auto upper_of = [&](const float(*n)[block_width]) {
        return cone_upper(Four::load(n[b]), Four::load(n[c]), Four::load(n[a]), u0, u1, v0, v1);
    };
    const auto lower_of = [&](const float(*n)[block_width]) {
        const Four nu = Four::load(n[b]), nv = Four::load(n[c]);
        return min_or(nu * u0, nu * u1) + min_or(nv * v0, nv * v1) + Four::load(n[a]);
    };
    f.front = sum_bound < lower_of(f.normal);
    f.back = upper_of(f.normal) < Four(0.0f) - sum_bound;
    unsigned outside = 0;
    for (const auto& edge : f.edge) {
        outside |= f.front & (upper_of(edge) < Four(0.0f) - bound);
        outside |= f.back & (bound < lower_of(edge));
    }
    f.alive = ~outside & 0xf;
}

LUCH_INLINE void look_at(const Bundle& bundle, const Block& block, Facets& f) {
    const Three<Four> origin = all<Four>(bundle.origin);
    Three<Four> p[3], a[3];
    for (int k = 0; k < 3; ++k) {
        const auto at = [&](int axis) { return Four::load(block.corner[3 * k + axis]); };
        p[k] = {at(0), at(1), at(2)};
        a[k] = minus(p[k], origin);
    }
    const Three<Four> edges[3] = {minus(a[2], a[1]), minus(a[0], a[2]), minus(a[1], a[0])};
    store(cross(a[1], edges[0]), f.edge[0]);
    store(cross(a[2], edges[1]), f.edge[1]);
    store(cross(a[0], edges[2]), f.edge[2]);
    const Three<Four> edge1 = minus(p[1], p[0]), edge2 = minus(p[2], p[0]);
    const Three<Four> normal = cross(edge1, edge2);
    store(normal, f.normal);
    const Four above = dot(normal, a[0]);
    above.store(f.above);
    store(lower(a[0], lower(a[1], a[2])), f.lo);
    store(upper(a[0], upper(a[1], a[2])), f.hi);
    const Four edge_size = Four::load(block.edge), size = size_of(a[0], edge_size);
    const Four sum(bundle.direction_sum);
    sign_bound(size, edge_size, sum).store(f.ray_bound);
    sign_bound(edge_size, edge_size, sum).store(f.slope_bound);
    f.above_certain = sign_bound(edge_size, edge_size, sum_of_sizes(a[0])) < abs(above);
    cull(bundle, size, edge_size, f);
}

/// A bit for every group whose cone may hold a ray through triangle k.
LUCH_INLINE unsigned groups_inside(const Bundle& bundle, const Facets& f, int k) {
    const unsigned bit = 1u << k;
    if (((f.front | f.back) & bit) == 0) return 0xffff;
    const bool front = (f.front & bit) != 0;
    const float flip = front ? 1.0f : -1.0f;
    const int a = bundle.main, b = (a + 1) % 3, c = (a + 2) % 3;
    const Sixteen bound(-f.cone_bound[k]);
    unsigned outside = 0;
    for (const auto& edge : f.edge) {
        const float nu = flip * edge[b][k], nv = flip * edge[c][k];
        const Sixteen u = Sixteen::load(nu > 0 ? bundle.u.hi : bundle.u.lo);
        const Sixteen v = Sixteen::load(nv > 0 ? bundle.v.hi : bundle.v.lo);
        outside |= (Sixteen(nu) * u + Sixteen(nv) * v + Sixteen(flip * edge[a][k])) < bound;
    }
    return ~outside & 0xffff;
}

}  // namespace
}  // namespace luch::wide
