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
LUCH_INLINE Sixteen lesser(const Sixteen& a, const Sixteen& b) {
    return min_or(a, b);
}
LUCH_INLINE Sixteen greater(const Sixteen& a, const Sixteen& b) {
    return max_or(a, b);
}
LUCH_INLINE unsigned lanes_below(float a, float b) {
    return a < b ? 0xffff : 0;
}
LUCH_INLINE unsigned lanes_below(const Sixteen& a, const Sixteen& b) {
    return a < b;
}

/// A triangle as seen from where the rays start: one for all sixteen, or (T = Sixteen) one for
/// each.
template <class T>
struct Look {
    Three<T> edge[3];         ///< a_i × a_j
    Three<T> normal, lo, hi;  ///< and the box
    T above, size;            ///< normal · a_0; the largest |component| of the edges
    unsigned certain;         ///< the sign of `above` is

    Look() = default;
    LUCH_INLINE Look(const Three<T> (&p)[3], const T& edge_size, const Three<T>& origin)
        : size(edge_size) {
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
        using std::abs;
        certain = lanes_below(wide::sign_bound(size, size, wide::sum_of_sizes(a[0])), abs(above));
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

/// The hits of a tile with the triangles of one node.
class Resolver {
 public:
    LUCH_INLINE Resolver(const Target& target, const RayPacket& rays, HitPacket& hits)
        : target_(target), rays_(rays), hits_(hits) {
        const Vec3 origin(target.to_object->point(rays.origin));
        origin_ = {origin.x, origin.y, origin.z};
        turn();
        std::fill(held_, held_ + looks, no_item);
    }

    LUCH_INLINE void resolve(const std::uint32_t* items) {
        for (int first = 0; first < RayPacket::capacity; first += 16) {
            resolve_group(items + first, first);
        }
    }

 private:
    static constexpr int looks = 8;

    /// The same operations as Transform::direction and object_ray().
    LUCH_INLINE void turn() {
        for (int axis = 0; axis < 3; ++axis) {
            const auto& m = target_.to_object->matrix[axis];
            const double mx = m[0], my = m[1], mz = m[2];
            for (int i = 0; i < RayPacket::capacity; ++i) {
                direction_[axis][i] =
                    static_cast<float>(rays_.x[i] * mx + rays_.y[i] * my + rays_.z[i] * mz);
            }
        }
    }

    LUCH_INLINE void resolve_group(const std::uint32_t* items, int first) {
        std::uint32_t index[16], others = 0;
        for (int i = 0; i < 16; ++i) {
            index[i] = items[i] - target_.base;
            others |= items[i] ^ items[0];
        }
        if (others == 0) {
            if (index[0] < target_.count) alone(index[0], 0xffff, first);
            return;
        }
        const unsigned ours = those(index, [&](std::uint32_t i) { return i < target_.count; });
        if (ours == 0) return;
        const std::uint32_t one = index[std::countr_zero(ours)];
        others = 0;
        for (std::uint32_t& i : index) {
            i = i < target_.count ? i : one;
            others |= i ^ one;
        }
        if (others == 0) return alone(one, ours, first);
        each_its_own(index, ours, first);
    }

    /// A bit for each of sixteen that `is` says yes to.
    template <class Is>
    LUCH_INLINE static unsigned those(const std::uint32_t (&index)[16], Is&& is) {
        alignas(64) float yes[16];
        for (int i = 0; i < 16; ++i) yes[i] = is(index[i]) ? 1.0f : 0.0f;
        return Sixteen(0.5f) < Sixteen::load(yes);
    }

    LUCH_INLINE Three<Sixteen> directions(int first) const {
        return {Sixteen::load(direction_[0] + first), Sixteen::load(direction_[1] + first),
                Sixteen::load(direction_[2] + first)};
    }

    /// All that are ours show one triangle.
    LUCH_INLINE void alone(std::uint32_t index, unsigned ours, int first) {
        const Triangle& triangle = target_.triangles[index];
        const int at = static_cast<int>(index % looks);
        if (held_[at] != index) {
            const auto corner = [&](int k) {
                return Three<float>{triangle.corner[3 * k], triangle.corner[3 * k + 1],
                                    triangle.corner[3 * k + 2]};
            };
            look_[at] = Look<float>({corner(0), corner(1), corner(2)}, triangle.edge, origin_);
            held_[at] = index;
        }
        keep(found_by(look_[at], directions(first)), ours, first);
        for (int i = 0; i < 16; ++i) {
            const bool here = (ours >> i & 1) != 0;
            hits_.node[first + i] = here ? target_.node : hits_.node[first + i];
            hits_.primitive[first + i] = here ? triangle.id : hits_.primitive[first + i];
        }
        const unsigned doubtful = ours & ~certain_;
        if (doubtful == 0) return;
        std::uint32_t same[16];
        std::fill(same, same + 16, index);
        ask(same, doubtful, first);
    }

    LUCH_INLINE void each_its_own(const std::uint32_t (&index)[16], unsigned ours, int first) {
        alignas(64) float corner[9][16], edge[16];
        for (int i = 0; i < 16; ++i) {
            const Triangle& triangle = target_.triangles[index[i]];
            for (int k = 0; k < 9; ++k) corner[k][i] = triangle.corner[k];
            edge[i] = triangle.edge;
            const bool here = (ours >> i & 1) != 0;
            hits_.node[first + i] = here ? target_.node : hits_.node[first + i];
            hits_.primitive[first + i] = here ? triangle.id : hits_.primitive[first + i];
        }
        const auto at = [&](int k) {
            return Three<Sixteen>{Sixteen::load(corner[3 * k]), Sixteen::load(corner[3 * k + 1]),
                                  Sixteen::load(corner[3 * k + 2])};
        };
        const Three<Sixteen> origin{origin_.x, origin_.y, origin_.z};
        const Look<Sixteen> look({at(0), at(1), at(2)}, Sixteen::load(edge), origin);
        keep(found_by(look, directions(first)), ours, first);
        const unsigned doubtful = ours & ~certain_;
        if (doubtful != 0) ask(index, doubtful, first);
    }

    LUCH_INLINE void keep(const Found& found, unsigned ours, int first) {
        certain_ = found.certain;
        const auto put = [&](const Sixteen& value, float* to) {
            Sixteen::select(ours, value, Sixteen::load(to + first)).store(to + first);
        };
        put(found.t, hits_.t);
        put(found.u, hits_.u);
        put(found.v, hits_.v);
    }

    /// The hit function itself, where the lanes are not certain of what it would say.
    [[gnu::noinline]] void ask(const std::uint32_t (&index)[16], unsigned doubtful, int first) {
        for (; doubtful != 0; doubtful &= doubtful - 1) {
            const int i = std::countr_zero(doubtful);
            const Triangle& triangle = target_.triangles[index[i]];
            TriangleHit hit;
            const bool found =
                intersect_triangle(object_ray(target_.to_object->ray(rays_.ray(first + i))),
                                   triangle.point(0), triangle.point(1), triangle.point(2),
                                   target_.cull_backfaces, hit);
            hits_.set(first + i, found ? Hit{hit.t, hit.u, hit.v, target_.node, triangle.id}
                                       : Hit{});
        }
    }

    const Target& target_;
    const RayPacket& rays_;
    HitPacket& hits_;
    Three<float> origin_;
    unsigned certain_ = 0;  ///< of the group before
    alignas(64) float direction_[3][RayPacket::capacity];
    std::uint32_t held_[looks];  ///< which triangles the looks are of
    Look<float> look_[looks];
};

void resolve(const Target& target, const std::uint32_t* items, const RayPacket& rays,
             HitPacket& hits) {
    Resolver(target, rays, hits).resolve(items);
}

}  // namespace
}  // namespace luch::raster
