#pragma once

#include "framework/raster/set_up.h"

// From items to hits: the operations of intersect_triangle() in the same order, for sixteen pixels
// at once. Only kernel files include this; nothing here has linkage.
namespace luch::raster {
namespace {

LUCH_INLINE float lesser(float a, float b) {
    return a < b ? a : b;
}
LUCH_INLINE float greater(float a, float b) {
    return a > b ? a : b;
}
/// A triangle as seen from where the rays start: one for all sixteen, or (T = Sixteen) one for
/// each.
template <class T>
struct Look {
    Three<T> edge[3];         ///< a_i × a_j
    Three<T> normal, lo, hi;  ///< and the box
    T above, size;            ///< normal · a_0; the largest |component| of the edges
    T id;                     ///< the bits of the triangle's number
    unsigned certain;         ///< the sign of `above` is

    Look() = default;
    LUCH_INLINE Look(const Triangle& triangle, const Three<T>& origin)
        : size(triangle.edge), id(std::bit_cast<float>(triangle.id)) {
        const float* c = triangle.corner;
        const Three<T> p[3] = {{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]}};
        const Three<T> a[3] = {minus(p[0], origin), minus(p[1], origin), minus(p[2], origin)};
        for (int k = 0; k < 3; ++k) {
            const Three<T>&from = a[(k + 1) % 3], &to = a[(k + 2) % 3];
            edge[k] = cross(from, minus(to, from));
        }
        normal = cross(minus(p[1], p[0]), minus(p[2], p[0]));
        above = dot(normal, a[0]);
        lo = {lesser(a[0].x, lesser(a[1].x, a[2].x)), lesser(a[0].y, lesser(a[1].y, a[2].y)),
              lesser(a[0].z, lesser(a[1].z, a[2].z))};
        hi = {greater(a[0].x, greater(a[1].x, a[2].x)), greater(a[0].y, greater(a[1].y, a[2].y)),
              greater(a[0].z, greater(a[1].z, a[2].z))};
        const float bound = wide::sign_bound(size, size, wide::sum_of_sizes(a[0]));
        certain = bound < std::abs(above) ? 0xffff : 0;
    }

    /// Takes another one for some lanes.
    LUCH_INLINE void take(unsigned lanes, const Look<float>& other) {
        const auto each = [&](T& to, float from) { to = T::select(lanes, from, to); };
        const auto all = [&](Three<T>& to, const Three<float>& from) {
            each(to.x, from.x);
            each(to.y, from.y);
            each(to.z, from.z);
        };
        for (int k = 0; k < 3; ++k) all(edge[k], other.edge[k]);
        all(normal, other.normal);
        all(lo, other.lo);
        all(hi, other.hi);
        each(above, other.above);
        each(size, other.size);
        each(id, other.id);
        certain = (certain & ~lanes) | (other.certain & lanes);
    }
};

/// t, u, v, and the lanes in which they are those of the hit function.
struct Found {
    Sixteen t, u, v;
    unsigned certain;
};

LUCH_INLINE void clip(const Sixteen& lo, const Sixteen& hi, const Sixteen& direction, Sixteen& near,
                      Sixteen& far) {
    const Sixteen inverse = Sixteen(1.0f) / direction;
    const unsigned negative = inverse < Sixteen(0.0f);
    near = max_or(Sixteen::select(negative, hi, lo) * inverse, near);
    far = min_or(Sixteen::select(negative, lo, hi) * inverse, far);
}

/// barycentric() in lanes.
LUCH_INLINE Sixteen share(const Sixteen& part, const Sixteen& whole, const Sixteen& limit) {
    const Sixteen ratio = part / whole;
    return Sixteen::select(Sixteen(0.0f) < ratio, min_or(limit, ratio), 0.0f);
}

template <class T>
LUCH_INLINE Found found_by(const Look<T>& at, const Three<Sixteen>& direction) {
    const Sixteen along = dot(at.normal, direction);
    Sixteen near(-infinite), far(infinite);
    clip(at.lo.x, at.hi.x, direction.x, near, far);
    clip(at.lo.y, at.hi.y, direction.y, near, far);
    clip(at.lo.z, at.hi.z, direction.z, near, far);
    far = max_or(far * Sixteen(far_padding), far);
    Found found;
    found.t = min_or(far, max_or(near, Sixteen(at.above) / along));
    found.certain =
        at.certain &
        (wide::sign_bound(at.size, at.size, wide::sum_of_sizes(direction)) < abs(along)) &
        (near <= far) & (Sixteen(0.0f) < found.t) & (found.t < Sixteen(infinite));
    const Sixteen w1 = dot(at.edge[1], direction), w2 = dot(at.edge[2], direction);
    const Sixteen whole = dot(at.edge[0], direction) + w1 + w2;
    found.u = share(w1, whole, 1.0f);
    found.v = share(w2, whole, Sixteen(1.0f) - found.u);
    return found;
}

LUCH_INLINE void put_all(const Hit& hit, HitPacket& hits, int first, int last) {
    std::fill(hits.t + first, hits.t + last, hit.t);
    std::fill(hits.u + first, hits.u + last, hit.u);
    std::fill(hits.v + first, hits.v + last, hit.v);
    std::fill(hits.node + first, hits.node + last, hit.node);
    std::fill(hits.primitive + first, hits.primitive + last, hit.primitive);
}

/// The hits of a tile with the triangles of one node. `fresh`: all others become Hit{}, else they
/// stay.
template <bool fresh>
class Resolver {
 public:
    LUCH_INLINE Resolver(const Target& target, const RayPacket& rays, HitPacket& hits)
        : target_(target), rays_(rays), hits_(hits) {
        const Vec3 origin(target.to_object->point(rays.origin));
        origin_ = {normal_or_zero(origin.x), normal_or_zero(origin.y), normal_or_zero(origin.z)};
        turn();
        std::fill(held_, held_ + looks, no_item);
    }

    LUCH_INLINE void resolve(const std::uint32_t* items) {
        for (int first = 0; first < RayPacket::capacity; first += 16) {
            resolve_group(items + first, first);
        }
    }

 private:
    static constexpr int looks = 16;

    /// The same operations as Transform::direction and object_ray().
    LUCH_INLINE void turn() {
        for (int axis = 0; axis < 3; ++axis) {
            const auto& m = target_.to_object->matrix[axis];
            const double mx = m[0], my = m[1], mz = m[2];
            for (int i = 0; i < RayPacket::capacity; ++i) {
                direction_[axis][i] =
                    static_cast<float>(rays_.x[i] * mx + rays_.y[i] * my + rays_.z[i] * mz);
            }
            for (int i = 0; i < RayPacket::capacity; i += 16) {
                wide::drop_denormals(direction_[axis] + i);
            }
        }
    }

    LUCH_INLINE void resolve_group(const std::uint32_t* items, int first) {
        const unsigned ours = Sixteen::below(items, target_.base + target_.count) &
                              ~Sixteen::below(items, target_.base);
        if (ours == 0) return clear(first);
        const std::uint32_t one = items[std::countr_zero(ours)];
        unsigned rest = ours & ~Sixteen::equal(items, one);
        if (rest == 0) return keep(look_at(one), items, ours, first);
        Look<Sixteen> look;
        look.take(0xffff, look_at(one));
        while (rest != 0) {
            const std::uint32_t next = items[std::countr_zero(rest)];
            const unsigned same = Sixteen::equal(items, next);
            look.take(same, look_at(next));
            rest &= ~same;
        }
        keep(look, items, ours, first);
    }

    LUCH_INLINE void clear(int first) {
        if (fresh) put_all(Hit{}, hits_, first, first + 16);
    }

    LUCH_INLINE Three<Sixteen> directions(int first) const {
        return {Sixteen::load(direction_[0] + first), Sixteen::load(direction_[1] + first),
                Sixteen::load(direction_[2] + first)};
    }

    LUCH_INLINE const Look<float>& look_at(std::uint32_t item) {
        const auto at = static_cast<int>(item % looks);
        if (held_[at] != item) {
            look_[at] = Look<float>(target_.triangles[item - target_.base], origin_);
            held_[at] = item;
        }
        return look_[at];
    }

    template <class T>
    LUCH_INLINE void keep(const Look<T>& look, const std::uint32_t* items, unsigned ours,
                          int first) {
        const Found found = found_by(look, directions(first));
        const auto put = [&](const Sixteen& value, float other, float* to) {
            Sixteen::select(ours, value, fresh ? Sixteen(other) : Sixteen::load(to + first))
                .store(to + first);
        };
        const auto name = [&](std::uint32_t other, const Sixteen& value, std::uint32_t* to) {
            Sixteen::select(
                ours, value,
                fresh ? Sixteen(std::bit_cast<float>(other)) : Sixteen::load_bits(to + first))
                .store_bits(to + first);
        };
        put(found.t, infinite, hits_.t);
        put(found.u, 0, hits_.u);
        put(found.v, 0, hits_.v);
        name(no_node, std::bit_cast<float>(target_.node), hits_.node);
        name(0, look.id, hits_.primitive);
        const unsigned doubtful = ours & ~found.certain;
        if (doubtful != 0) ask(items, doubtful, first);
    }

    /// The hit function itself, where the lanes are not certain of what it would say.
    [[gnu::noinline]] void ask(const std::uint32_t* items, unsigned doubtful, int first) {
        for (; doubtful != 0; doubtful &= doubtful - 1) {
            const int i = std::countr_zero(doubtful);
            const Triangle& triangle = target_.triangles[items[i] - target_.base];
            TriangleHit hit;
            const bool found = intersect_triangle(
                object_ray(target_.to_object->ray(rays_.ray(first + i))), triangle.point(0),
                triangle.point(1), triangle.point(2), target_.cull_backfaces, hit);
            hits_.set(first + i,
                      found ? Hit{hit.t, hit.u, hit.v, target_.node, triangle.id} : Hit{});
        }
    }

    const Target& target_;
    const RayPacket& rays_;
    HitPacket& hits_;
    Three<float> origin_;
    alignas(64) float direction_[3][RayPacket::capacity];
    std::uint32_t held_[looks];  ///< which triangles the looks are of
    Look<float> look_[looks];
};

void miss(HitPacket& hits) {
    put_all(Hit{}, hits, 0, RayPacket::capacity);
}

void resolve(const Target& target, const std::uint32_t* items, const RayPacket& rays, bool fresh,
             HitPacket& hits) {
    if (fresh) return Resolver<true>(target, rays, hits).resolve(items);
    Resolver<false>(target, rays, hits).resolve(items);
}

Survey survey(const std::uint32_t* items) {
    std::uint32_t ambiguous = 0, lowest = no_item, highest = 0;
    for (int i = 0; i < RayPacket::capacity; ++i) {
        ambiguous += items[i] >> 31;
        lowest = std::min(lowest, items[i]);
        highest = std::max(highest, items[i] < no_item ? items[i] : 0u);
    }
    return {static_cast<int>(ambiguous), lowest, highest};
}

}  // namespace
}  // namespace luch::raster
