#pragma once

#include "framework/accel/wide/lanes.h"
#include "framework/raster/kernels.h"

#include <bit>

// Sixteen triangles at a time become facets; facet.h tells what the bounds are. Only kernel files
// include this; nothing here has linkage.
namespace luch::raster {
namespace {

using wide::cross;
using wide::dot;
using wide::minus;
using wide::Three;
using Sixteen = simd::Lanes<16>;

inline constexpr float infinite = std::numeric_limits<float>::infinity();

LUCH_INLINE Three<Sixteen> all(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}
LUCH_INLINE Sixteen least(const Sixteen (&v)[3]) {
    return min_or(v[0], min_or(v[1], v[2]));
}
LUCH_INLINE Sixteen most(const Sixteen (&v)[3]) {
    return max_or(v[0], max_or(v[1], v[2]));
}
/// The largest value in a box of a linear function.
LUCH_INLINE Sixteen upper_in(const Three<Sixteen>& lo, const Three<Sixteen>& hi,
                             const float (&v)[3]) {
    return (v[0] < 0 ? lo.x : hi.x) * v[0] + (v[1] < 0 ? lo.y : hi.y) * v[1] +
           (v[2] < 0 ? lo.z : hi.z) * v[2];
}
/// The least whole number that is not below, for sizes up to 2²².
LUCH_INLINE Sixteen rounded_up(const Sixteen& v) {
    const Sixteen shift(0x1.8p23f);
    const Sixteen nearest = (v + shift) - shift;
    return Sixteen::select(nearest < v, nearest + 1.0f, nearest);
}

/// What is written for sixteen triangles, before it is picked apart.
struct Drafts {
    alignas(64) float edge[3][3][16];
    alignas(64) float depth[3][16];
    alignas(64) float rho[16], doubt[16];
    alignas(64) float span[4][16];
    alignas(64) float lo[3][16], hi[3][16];
    unsigned seen, regular, sane, turned;
};

/// Edges, depth and their bounds.
class Shape {
 public:
    Three<Sixteen> a[3];    ///< corners relative to the origin
    Three<Sixteen> lo, hi;  ///< and their box
    Sixteen size, edge, bound, above, spread;
    unsigned sane;

    LUCH_INLINE Shape(const View& view, const Block& block, Drafts& drafts) {
        const Three<Sixteen> origin = all(view.origin);
        Three<Sixteen> p[3];
        for (int k = 0; k < 3; ++k) {
            p[k] = {Sixteen::load(block.corner[3 * k]), Sixteen::load(block.corner[3 * k + 1]),
                    Sixteen::load(block.corner[3 * k + 2])};
            a[k] = minus(p[k], origin);
        }
        lo = wide::lower(a[0], wide::lower(a[1], a[2]));
        hi = wide::upper(a[0], wide::upper(a[1], a[2]));
        edge = Sixteen::load(block.edge);
        size = wide::size_of(a[0], edge);
        bound = Sixteen(2.5f) * wide::sign_bound(size, edge, Sixteen(view.sum));
        spread = Sixteen(1.2f * 0x1p-18f) * edge * edge;
        sane = (size < Sixteen(0x1p40f)) & (Sixteen(0x1p-80f) < bound);
        const Three<Sixteen> normal = cross(minus(p[1], p[0]), minus(p[2], p[0]));
        above = dot(normal, a[0]);
        const Sixteen sign = Sixteen::select(above < Sixteen(0.0f), -1.0f, 1.0f);
        const Sixteen scale = sign / bound, inverse = Sixteen(1.0f) / above;
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            store(view, cross(a[i], minus(a[j], a[i])), scale, drafts.edge[k]);
        }
        store(view, normal, inverse, drafts.depth);
    }

    /// The relative error of inverse depths down to 1/w.
    LUCH_INLINE Sixteen rho(const View& view, const Sixteen& w) const {
        const Sixteen reach = wide::sum_of_sizes(a[0]) + Sixteen(1.1f * view.sum) * w;
        return spread * reach / abs(above) + Sixteen(0x1p-19f);
    }

 private:
    LUCH_INLINE static void store(const View& view, const Three<Sixteen>& normal,
                                  const Sixteen& scale, float (*to)[16]) {
        (dot(normal, all(view.d)) * scale).store(to[0]);
        (dot(normal, all(view.dx)) * scale).store(to[1]);
        (dot(normal, all(view.dy)) * scale).store(to[2]);
    }
};

/// Where the corners stand on the frame.
struct Corners {
    Sixteen w[3], lo[2], hi[2];

    LUCH_INLINE Corners(const View& view, const Shape& shape) {
        Sixteen least_of[2][3], most_of[2][3];
        for (int k = 0; k < 3; ++k) {
            w[k] = dot(shape.a[k], all(view.to_w));
            const Sixteen inverse = Sixteen(1.0f) / w[k];
            const Sixteen slack = Sixteen(0x1p-19f) * shape.size * inverse;
            const Sixteen x = dot(shape.a[k], all(view.to_x)) * inverse;
            const Sixteen y = dot(shape.a[k], all(view.to_y)) * inverse;
            const Sixteen pad_x = slack * (Sixteen(view.size_x) + abs(x) * view.size_w);
            const Sixteen pad_y = slack * (Sixteen(view.size_y) + abs(y) * view.size_w);
            least_of[0][k] = x - pad_x;
            most_of[0][k] = x + pad_x;
            least_of[1][k] = y - pad_y;
            most_of[1][k] = y + pad_y;
        }
        for (int axis = 0; axis < 2; ++axis) {
            lo[axis] = least(least_of[axis]);
            hi[axis] = most(most_of[axis]);
        }
    }
};

/// A bit for every triangle whose box some ray may meet.
LUCH_INLINE unsigned in_sight(const View& view, const Shape& shape) {
    unsigned out = 0;
    for (int i = 0; i < 5; ++i) {
        const Sixteen slack = shape.size * view.slack[i];
        out |= upper_in(shape.lo, shape.hi, view.plane[i]) < Sixteen(0.0f) - slack;
    }
    return ~out;
}

/// What no hit of a triangle exceeds where edges are in doubt, as facet.h has it. Where all values
/// are ≥ −1, no w_k is below −2 bound; t · d has weights w_k / W in the plane, so it leaves a side
/// of the box by at most 4 bound / W of the box's width, and clamping to that side at distance m
/// from the origin makes 1/t larger by 4 bound / ((a0 × a1)·a2) · edge / m at most. The rounding of
/// n·D adds what rho has of it. Both hold while 1/t exceeds 0.4/reach and that rounding: corners
/// ahead weigh W ≥ (a0 × a1)·a2 / farthest − 4 bound, any others a third of that for the size.
/// Where this cannot be used, the box's nearest corner bounds it.
LUCH_INLINE void bound_doubt(const View& view, const Shape& shape, const Sixteen& reach,
                             const Sixteen& rho, Drafts& drafts) {
    const Sixteen zero(0.0f), slack = Sixteen(0x1p-18f) * shape.size * view.size_w;
    const float turned[3] = {-view.to_w[0], -view.to_w[1], -view.to_w[2]};
    const Sixteen nearest = zero - upper_in(shape.lo, shape.hi, turned) - slack;
    const Sixteen of_box = Sixteen::select(slack < nearest, Sixteen(1.0001f) / nearest, infinite);
    Sixteen closest(infinite);
    const auto side = [&](const Sixteen& at) {
        closest = min_or(Sixteen::select(zero < at, at, infinite), closest);
    };
    for (const auto& at : {shape.hi.x, shape.hi.y, shape.hi.z}) side(at);
    for (const auto& at : {shape.lo.x, shape.lo.y, shape.lo.z}) side(zero - at);
    const Sixteen above = abs(shape.above);
    const Sixteen rounding = shape.spread * Sixteen(1.1f * view.sum) / above;
    const Sixteen more = rounding + Sixteen(4.5f) * shape.bound * shape.edge / (closest * above);
    const unsigned valid = (Sixteen(4.0f) * shape.bound * reach < above) &
                           (rounding * reach < Sixteen(0.25f)) & (rho <= Sixteen(most_rho)) &
                           (more < Sixteen(0.5f) * of_box);
    Sixteen::select(valid, zero - more, of_box).store(drafts.doubt);
}

/// The pixels that a regular triangle may cover, and which ones are regular. Let M be the larger
/// side of the corners' span, δ = 1/16 + M/32. For a pixel further than δ outside, the weighted
/// corners Σ w_k (x_k − x) = 0 all lie on one side, so some w_k is below −W δ / 2(δ + M), where
/// W = Σ w_k ≥ (a0 × a1)·a2 / farthest; and some is above W/3. Both signs are certain to the hit
/// function when that exceeds the rounding of the ray's direction, 2 of the 40 in `bound`, so
/// (a0 × a1)·a2 > 2 (δ + M)/δ · farthest · bound/16 will do. The factor 3 has room for rounding.
LUCH_INLINE void bound_span(const View& view, const Shape& shape, Drafts& drafts) {
    const Corners corners(view, shape);
    const Sixteen farthest = max_or(most(corners.w), Sixteen(0.0f));
    const Sixteen longer = max_or(corners.hi[0] - corners.lo[0], corners.hi[1] - corners.lo[1]);
    const Sixteen delta = Sixteen(0x1p-4f) + longer * Sixteen(0x1p-5f);
    const Sixteen rho = shape.rho(view, farthest);
    const unsigned ahead = Sixteen(0x1p-14f) * shape.size * view.size_w < least(corners.w);
    const Sixteen needed = Sixteen(3.0f / 16) * (delta + longer) * farthest * shape.bound;
    drafts.regular =
        drafts.sane & ahead & (rho <= Sixteen(most_rho)) & (needed < abs(shape.above) * delta);
    rho.store(drafts.rho);
    const Sixteen reach =
        Sixteen::select(ahead, Sixteen(1.5f) * farthest, Sixteen(6 * view.size_w) * shape.size);
    bound_doubt(view, shape, reach, rho, drafts);
    const float ends[2][2] = {
        {-static_cast<float>(view.middle_x), static_cast<float>(view.width - 1 - view.middle_x)},
        {-static_cast<float>(view.middle_y), static_cast<float>(view.height - 1 - view.middle_y)}};
    unsigned empty = 0;
    for (int axis = 0; axis < 2; ++axis) {
        const Sixteen first = max_or(corners.lo[axis] - delta, ends[axis][0]);
        const Sixteen last = min_or(corners.hi[axis] + delta, ends[axis][1]);
        const Sixteen from = rounded_up(min_or(first, ends[axis][1] + 1.0f));
        const Sixteen to =
            Sixteen(0.0f) - rounded_up(Sixteen(0.0f) - max_or(last, ends[axis][0] - 1.0f));
        empty |= to < from;
        from.store(drafts.span[axis]);
        to.store(drafts.span[2 + axis]);
    }
    drafts.seen &= ~(drafts.regular & empty);
}

LUCH_INLINE void draft(const View& view, const Block& block, Drafts& drafts) {
    const Shape shape(view, block, drafts);
    const unsigned used = (1u << block.count) - 1;
    drafts.sane = shape.sane;
    drafts.seen = used & in_sight(view, shape);
    drafts.turned = view.cull_backfaces ? Sixteen(0.0f) < shape.above : 0;
    if (drafts.seen == 0) return;
    bound_span(view, shape, drafts);
    drafts.seen &= ~(drafts.regular & drafts.turned);  // some sign is positive: not hit anywhere
    for (int axis = 0; axis < 3; ++axis) {
        (axis == 0 ? shape.lo.x : axis == 1 ? shape.lo.y : shape.lo.z).store(drafts.lo[axis]);
        (axis == 0 ? shape.hi.x : axis == 1 ? shape.hi.y : shape.hi.z).store(drafts.hi[axis]);
    }
}

/// Writes lane i; whether it can be seen.
LUCH_INLINE bool write(const View& view, const Drafts& drafts, int i, Facet& facet, Span& span) {
    for (int k = 0; k < 3; ++k) {
        for (int c = 0; c < 3; ++c) facet.edge[k][c] = drafts.edge[k][c][i];
        facet.depth[k] = drafts.depth[k][i];
    }
    facet.rho = drafts.rho[i];
    facet.doubt = drafts.doubt[i];
    facet.kind = Kind::regular;
    if ((drafts.regular >> i & 1) != 0) {
        span = {static_cast<std::int16_t>(static_cast<int>(drafts.span[0][i]) + view.middle_x),
                static_cast<std::int16_t>(static_cast<int>(drafts.span[1][i]) + view.middle_y),
                static_cast<std::int16_t>(static_cast<int>(drafts.span[2][i]) + view.middle_x),
                static_cast<std::int16_t>(static_cast<int>(drafts.span[3][i]) + view.middle_y)};
        return true;
    }
    const Box box{{drafts.lo[0][i], drafts.lo[1][i], drafts.lo[2][i]},
                  {drafts.hi[0][i], drafts.hi[1][i], drafts.hi[2][i]}};
    return complete(view, box, (drafts.sane >> i & 1) != 0, (drafts.turned >> i & 1) != 0, facet,
                    span);
}

int set_up(const View& view, const Block* blocks, int count, Facet* facets, Span* spans) {
    int written = 0;
    Drafts drafts;
    for (int b = 0; b < count; ++b) {
        draft(view, blocks[b], drafts);
        for (unsigned rest = drafts.seen; rest != 0; rest &= rest - 1) {
            const int i = std::countr_zero(rest);
            if (!write(view, drafts, i, facets[written], spans[written])) continue;
            facets[written].item = view.base + blocks[b].first + static_cast<unsigned>(i);
            ++written;
        }
    }
    return written;
}

}  // namespace
}  // namespace luch::raster
