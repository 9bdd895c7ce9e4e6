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
    alignas(64) float anchor[2][16];  ///< from the frame's middle
    alignas(64) float lo[3][16], hi[3][16];
    unsigned seen, regular, sane, turned;
};

/// Edges, depth and their bounds.
class Shape {
 public:
    Three<Sixteen> a[3];                         ///< corners relative to the origin
    Three<Sixteen> lo, hi;                       ///< and their box
    Sixteen size, edge, certain, above, spread;  ///< certain: where signs are to the hit function
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
        certain = Sixteen(2.5f / 16) * wide::sign_bound(size, edge, Sixteen(view.sum));
        spread = Sixteen(1.2f * 0x1p-18f) * edge * edge;
        sane = (size < Sixteen(0x1p40f)) & (Sixteen(0x1p-80f) < certain);
        const Three<Sixteen> normal = cross(minus(p[1], p[0]), minus(p[2], p[0]));
        above = dot(normal, a[0]);
        const Sixteen inverse = Sixteen(1.0f) / above;
        (dot(normal, all(view.d)) * inverse).store(drafts.depth[0]);
        (dot(normal, all(view.dx)) * inverse).store(drafts.depth[1]);
        (dot(normal, all(view.dy)) * inverse).store(drafts.depth[2]);
    }

    /// The relative error of inverse depths down to 1/w.
    LUCH_INLINE Sixteen rho(const View& view, const Sixteen& w) const {
        const Sixteen reach = wide::sum_of_sizes(a[0]) + Sixteen(1.1f * view.sum) * w;
        return spread * reach / abs(above) + Sixteen(0x1p-19f);
    }
};

/// Where the corners stand on the frame.
struct Corners {
    Sixteen w[3], lo[2], hi[2];
    Sixteen farthest, longer, delta;

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
        farthest = max_or(most(w), Sixteen(0.0f));
        longer = max_or(hi[0] - lo[0], hi[1] - lo[1]);
        delta = Sixteen(0x1p-4f) + longer * Sixteen(0x1p-5f);
    }
    LUCH_INLINE unsigned ahead(const View& view, const Shape& shape) const {
        return Sixteen(0x1p-14f) * shape.size * view.size_w < least(w);
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
                             const Sixteen& rho, const Sixteen& bound, Drafts& drafts) {
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
    const Sixteen more = rounding + Sixteen(4.5f) * bound * shape.edge / (closest * above);
    const unsigned valid = (Sixteen(4.0f) * bound * reach < above) &
                           (rounding * reach < Sixteen(0.25f)) & (rho <= Sixteen(most_rho)) &
                           (more < Sixteen(0.5f) * of_box);
    Sixteen::select(valid, zero - more, of_box).store(drafts.doubt);
}

/// The coefficients of the edges, in double; see facet.h.
LUCH_INLINE void set_edges(const View& view, const Shape& shape, const Sixteen& bound,
                           Drafts& drafts) {
    alignas(64) float a[3][3][16], scale[16];
    for (int k = 0; k < 3; ++k) {
        shape.a[k].x.store(a[k][0]);
        shape.a[k].y.store(a[k][1]);
        shape.a[k].z.store(a[k][2]);
    }
    const Sixteen sign = Sixteen::select(shape.above < Sixteen(0.0f), -1.0f, 1.0f);
    (sign / bound).store(scale);
    for (int k = 0; k < 3; ++k) {
        const auto &p = a[(k + 1) % 3], &q = a[(k + 2) % 3];
        for (int i = 0; i < 16; ++i) {
            const double px = p[0][i], py = p[1][i], pz = p[2][i];
            const double ex = q[0][i] - px, ey = q[1][i] - py, ez = q[2][i] - pz;
            const double nx = py * ez - pz * ey, ny = pz * ex - px * ez, nz = px * ey - py * ex;
            const auto along = [&](const double(&d)[3]) {
                return (nx * d[0] + ny * d[1] + nz * d[2]) * static_cast<double>(scale[i]);
            };
            const double dx = along(view.dx_exact), dy = along(view.dy_exact);
            drafts.edge[k][0][i] = static_cast<float>(
                along(view.d_exact) + drafts.anchor[0][i] * dx + drafts.anchor[1][i] * dy);
            drafts.edge[k][1][i] = static_cast<float>(dx);
            drafts.edge[k][2][i] = static_cast<float>(dy);
        }
    }
}

/// Counts depths from the anchors, too.
LUCH_INLINE void move_depths(Drafts& drafts) {
    const auto part = [&](int i) {
        return Sixteen::load(drafts.depth[i + 1]) * Sixteen::load(drafts.anchor[i]);
    };
    (Sixteen::load(drafts.depth[0]) + (part(0) + part(1))).store(drafts.depth[0]);
}

/// Which triangles are regular. Let M be the larger side of the corners' span, δ = 1/16 + M/32. For
/// a pixel further than δ outside, the weighted corners Σ w_k (x_k − x) = 0 all lie on one side, so
/// some w_k is below −W δ / 2(δ + M), where W = Σ w_k ≥ (a0 × a1)·a2 / farthest; and some is above
/// W/3. Both signs are certain to the hit function if (a0 × a1)·a2 > 2 (δ + M)/δ · farthest ·
/// certain. The factor 3 has room for rounding.
LUCH_INLINE unsigned regular_ones(const View& view, const Shape& shape, const Corners& corners,
                                  const Sixteen& rho) {
    const Sixteen needed =
        Sixteen(3.0f) * (corners.delta + corners.longer) * corners.farthest * shape.certain;
    return shape.sane & corners.ahead(view, shape) & (rho <= Sixteen(most_rho)) &
           (needed < abs(shape.above) * corners.delta);
}

/// The pixels of regular triangles, and the anchors of all: the first of those pixels, for others
/// the middle of the frame.
LUCH_INLINE void set_spans(const View& view, const Corners& corners, Drafts& drafts) {
    const float ends[2][2] = {
        {-static_cast<float>(view.middle_x), static_cast<float>(view.width - 1 - view.middle_x)},
        {-static_cast<float>(view.middle_y), static_cast<float>(view.height - 1 - view.middle_y)}};
    unsigned empty = 0;
    for (int axis = 0; axis < 2; ++axis) {
        const Sixteen zero(0.0f);
        const Sixteen first = max_or(corners.lo[axis] - corners.delta, ends[axis][0]);
        const Sixteen last = min_or(corners.hi[axis] + corners.delta, ends[axis][1]);
        const Sixteen from = rounded_up(min_or(first, ends[axis][1] + 1.0f));
        const Sixteen to = zero - rounded_up(zero - max_or(last, ends[axis][0] - 1.0f));
        empty |= to < from;
        from.store(drafts.span[axis]);
        to.store(drafts.span[2 + axis]);
        Sixteen::select(drafts.regular, from, zero).store(drafts.anchor[axis]);
    }
    drafts.seen &= ~(drafts.regular & empty);
}

LUCH_INLINE void place(const View& view, const Shape& shape, Drafts& drafts) {
    const Corners corners(view, shape);
    const Sixteen rho = shape.rho(view, corners.farthest);
    rho.store(drafts.rho);
    drafts.regular = regular_ones(view, shape, corners, rho);
    set_spans(view, corners, drafts);
    if (drafts.seen == 0) return;
    const Sixteen frame(static_cast<float>(std::max(view.width, view.height)));
    const Sixteen away =
        Sixteen::select(drafts.regular, min_or(frame, Sixteen(1.1f) * corners.longer), frame);
    const Sixteen bound =
        Sixteen(1.01f * 0x1p-24f) * shape.size * (shape.edge + shape.size * Sixteen(0x1p-22f)) *
            (Sixteen(3 * view.sum) + (away + Sixteen(10.0f)) * Sixteen(26 * view.step)) +
        Sixteen((view.sum + 1) * wide::smallest_bound);
    const Sixteen reach =
        Sixteen::select(corners.ahead(view, shape), Sixteen(1.5f) * corners.farthest,
                        Sixteen(6 * view.size_w) * shape.size);
    bound_doubt(view, shape, reach, rho, bound, drafts);
    set_edges(view, shape, bound, drafts);
    move_depths(drafts);
}

LUCH_INLINE void draft(const View& view, const Block& block, Drafts& drafts) {
    const Shape shape(view, block, drafts);
    const unsigned used = (1u << block.count) - 1;
    drafts.sane = shape.sane;
    drafts.seen = used & in_sight(view, shape);
    drafts.turned = view.cull_backfaces ? Sixteen(0.0f) < shape.above : 0;
    if (drafts.seen == 0) return;
    place(view, shape, drafts);
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
    facet.x = static_cast<std::uint32_t>(static_cast<int>(drafts.anchor[0][i]) + view.middle_x);
    facet.y = static_cast<std::uint32_t>(static_cast<int>(drafts.anchor[1][i]) + view.middle_y);
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
