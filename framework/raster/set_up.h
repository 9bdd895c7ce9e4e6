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
    alignas(64) float a[3][3][16], above[16], volume[16];  ///< see Shape
    alignas(64) double normal[3][16];
    alignas(64) float span[4][16];
    alignas(64) float anchor[2][16];  ///< from the frame's middle
    alignas(64) float lo[3][16], hi[3][16];
    unsigned seen, regular, sane, turned;
};

/// Edges, depth and their bounds.
class Shape {
 public:
    Three<Sixteen> a[3];    ///< corners relative to the origin
    Three<Sixteen> lo, hi;  ///< and their box
    Sixteen size, edge;
    Sixteen certain;        ///< beyond it signs are certain to the hit function
    Sixteen above, volume;  ///< n·a0, (a0 × a1)·a2
    Sixteen products;       ///< what the rounding of n·a is proportional to
    unsigned sane;
    unsigned agree;  ///< above and volume certainly have the same sign

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
        sane = (size < Sixteen(0x1p40f)) & (Sixteen(0x1p-112f) < certain);
        const Three<Sixteen> one = minus(p[1], p[0]), two = minus(p[2], p[0]);
        const auto product = [](const Sixteen& x, const Sixteen& y) { return abs(x * y); };
        const auto larger = [](const Sixteen& x, const Sixteen& y) {
            return max_or(abs(x), abs(y));
        };
        products = (product(one.y, two.z) + product(one.z, two.y)) * larger(lo.x, hi.x) +
                   (product(one.z, two.x) + product(one.x, two.z)) * larger(lo.y, hi.y) +
                   (product(one.x, two.y) + product(one.y, two.x)) * larger(lo.z, hi.z);
        set_volumes(block, drafts);
        above = Sixteen::load(drafts.above);
        volume = Sixteen::load(drafts.volume);
        const Sixteen least_volume = Sixteen(0x1p-40f) * size * size * edge;
        agree = ((Sixteen(0.0f) < above) & (least_volume < volume)) |
                ((above < Sixteen(0.0f)) & (volume < Sixteen(0.0f) - least_volume));
    }

    /// What facet.h calls the bound of edge k; n_k is no larger than its nearer end allows.
    LUCH_INLINE Sixteen bound(int k, const Sixteen& unit, float sum) const {
        const Three<Sixteen>&from = a[(k + 1) % 3], &to = a[(k + 2) % 3];
        const Sixteen zero(0.0f), length = wide::largest(minus(to, from), zero);
        const Sixteen near = min_or(wide::largest(from, zero), wide::largest(to, zero));
        return Sixteen(1.01f * 0x1p-24f) * near * (length + size * Sixteen(0x1p-22f)) * unit +
               Sixteen((sum + 1) * wide::smallest_bound);
    }

    /// The relative error of inverse depths at and above 1/w, `depth` the size of their parts.
    LUCH_INLINE Sixteen rho(const Sixteen& w, const Sixteen& depth) const {
        return Sixteen(26 * 0x1p-24f) * products / abs(above) + Sixteen(12 * 0x1p-24f) * depth * w +
               Sixteen(0x1p-20f);
    }

 private:
    /// (a0 × a1)·a2 and n·a0 in double, n the normal.
    LUCH_INLINE void set_volumes(const Block& block, Drafts& drafts) const {
        for (int k = 0; k < 3; ++k) {
            a[k].x.store(drafts.a[k][0]);
            a[k].y.store(drafts.a[k][1]);
            a[k].z.store(drafts.a[k][2]);
        }
        const auto& p = block.corner;
        for (int i = 0; i < 16; ++i) {
            const auto along = [&](const Three<double>& n) {
                return static_cast<float>(n.x * drafts.a[0][0][i] + n.y * drafts.a[0][1][i] +
                                          n.z * drafts.a[0][2][i]);
            };
            const Three<double> corner{p[0][i], p[1][i], p[2][i]};
            const Three<double> one = minus(Three<double>{p[3][i], p[4][i], p[5][i]}, corner);
            const Three<double> two = minus(Three<double>{p[6][i], p[7][i], p[8][i]}, corner);
            const Three<double> normal = cross(one, two);
            drafts.normal[0][i] = normal.x;
            drafts.normal[1][i] = normal.y;
            drafts.normal[2][i] = normal.z;
            drafts.above[i] = along(normal);
            const Three<double> from{drafts.a[1][0][i], drafts.a[1][1][i], drafts.a[1][2][i]};
            const Three<double> to{drafts.a[2][0][i], drafts.a[2][1][i], drafts.a[2][2][i]};
            drafts.volume[i] = along(cross(from, minus(to, from)));
        }
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
/// from the origin makes 1/t larger by 4 bound / |volume| · edge / m at most. There |d_i| may
/// exceed max|a_i| / t by 8 bound / |volume| of max|a_i|, which adds rho of that. Both hold while
/// 1/t is at least 0.4/reach: corners ahead weigh W ≥ |volume| / farthest − 4 bound, any others a
/// third of that for the size. Where this cannot be used, the box's nearest corner bounds it.
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
    const Sixteen volume = abs(shape.volume);
    const Sixteen more = bound * (Sixteen(0.6f) + Sixteen(4.5f) * shape.edge / closest) / volume;
    const unsigned valid = (Sixteen(4.0f) * bound * reach < volume) & (rho <= Sixteen(most_rho)) &
                           (more < Sixteen(0.5f) * of_box);
    Sixteen::select(valid, zero - more, of_box).store(drafts.doubt);
}

LUCH_INLINE double along(const Three<double>& n, const double (&d)[3]) {
    return n.x * d[0] + n.y * d[1] + n.z * d[2];
}

/// The coefficients of the edges, in double; see facet.h.
LUCH_INLINE void set_edges(const View& view, const Shape& shape, const Sixteen (&bounds)[3],
                           Drafts& drafts) {
    alignas(64) float scale[16];
    const Sixteen sign = Sixteen::select(shape.volume < Sixteen(0.0f), -1.0f, 1.0f);
    for (int k = 0; k < 3; ++k) {
        (sign / bounds[k]).store(scale);
        const auto &p = drafts.a[(k + 1) % 3], &q = drafts.a[(k + 2) % 3];
        for (int i = 0; i < 16; ++i) {
            const Three<double> from{p[0][i], p[1][i], p[2][i]}, to{q[0][i], q[1][i], q[2][i]};
            const Three<double> n = cross(from, minus(to, from));
            const double unit = scale[i];
            const double dx = along(n, view.dx_exact) * unit, dy = along(n, view.dy_exact) * unit;
            drafts.edge[k][0][i] =
                static_cast<float>(along(n, view.d_exact) * unit + drafts.anchor[0][i] * dx +
                                   drafts.anchor[1][i] * dy);
            drafts.edge[k][1][i] = static_cast<float>(dx);
            drafts.edge[k][2][i] = static_cast<float>(dy);
        }
    }
}

/// Those of the inverse depth. Gives the size of its parts within `away` pixels of the anchor.
LUCH_INLINE Sixteen set_depths(const View& view, const Sixteen& away, Drafts& drafts) {
    for (int i = 0; i < 16; ++i) {
        const Three<double> n{drafts.normal[0][i], drafts.normal[1][i], drafts.normal[2][i]};
        const double unit = 1.0 / static_cast<double>(drafts.above[i]);
        const double dx = along(n, view.dx_exact) * unit, dy = along(n, view.dy_exact) * unit;
        drafts.depth[0][i] = static_cast<float>(
            along(n, view.d_exact) * unit + drafts.anchor[0][i] * dx + drafts.anchor[1][i] * dy);
        drafts.depth[1][i] = static_cast<float>(dx);
        drafts.depth[2][i] = static_cast<float>(dy);
    }
    const auto size = [&](int c) { return abs(Sixteen::load(drafts.depth[c])); };
    return size(0) + away * (size(1) + size(2));
}

/// Which triangles are regular. Let M be the larger side of the corners' span, δ = 1/16 + M/32. For
/// a pixel further than δ outside, the weighted corners Σ w_k (x_k − x) = 0 all lie on one side, so
/// some w_k is below −W δ / 2(δ + M), where W = Σ w_k ≥ (a0 × a1)·a2 / farthest; and some is above
/// W/3. Both signs are certain to the hit function if (a0 × a1)·a2 > 2 (δ + M)/δ · farthest ·
/// certain. The factor 3 has room for rounding.
LUCH_INLINE unsigned regular_ones(const View& view, const Shape& shape, const Corners& corners) {
    const Sixteen needed =
        Sixteen(3.0f) * (corners.delta + corners.longer) * corners.farthest * shape.certain;
    return shape.sane & shape.agree & corners.ahead(view, shape) &
           (needed < abs(shape.volume) * corners.delta);
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

/// Small regular triangles of which every pixel of the span is a miss: they lie between the points
/// that are looked at.
LUCH_INLINE unsigned between_pixels(const Drafts& drafts) {
    constexpr int most_across = 4;
    const auto last = [&](int axis) {
        return Sixteen::load(drafts.span[2 + axis]) - Sixteen::load(drafts.span[axis]);
    };
    const Sixteen last_x = last(0), last_y = last(1);
    const auto least_edge = [&](int x, int y) {
        Sixteen at[3];
        for (int k = 0; k < 3; ++k) {
            const auto& edge = drafts.edge[k];
            at[k] = Sixteen::load(edge[0]) + (Sixteen::load(edge[1]) * static_cast<float>(x) +
                                              Sixteen::load(edge[2]) * static_cast<float>(y));
        }
        return least(at);
    };
    unsigned missed = drafts.seen & drafts.regular &
                      (max_or(last_x, last_y) < Sixteen(static_cast<float>(most_across)));
    for (int i = 0; i < most_across * most_across && missed != 0; ++i) {
        const int x = i % most_across, y = i / most_across;
        const unsigned within =
            (Sixteen(static_cast<float>(x)) <= last_x) & (Sixteen(static_cast<float>(y)) <= last_y);
        missed &= ~within | (least_edge(x, y) < Sixteen(-1.0f));
    }
    return missed;
}

LUCH_INLINE void place(const View& view, const Shape& shape, Drafts& drafts) {
    const Corners corners(view, shape);
    drafts.regular = regular_ones(view, shape, corners);
    set_spans(view, corners, drafts);
    drafts.seen &= ~(drafts.regular & drafts.turned);  // some sign is positive: not hit anywhere
    if (drafts.seen == 0) return;
    const Sixteen frame(static_cast<float>(std::max(view.width, view.height)));
    const Sixteen away =
        Sixteen(10.0f) +
        Sixteen::select(drafts.regular, min_or(frame, Sixteen(1.1f) * corners.longer), frame);
    const Sixteen unit = Sixteen(3 * view.sum) + away * Sixteen(26 * view.step);
    const Sixteen bounds[3] = {shape.bound(0, unit, view.sum), shape.bound(1, unit, view.sum),
                               shape.bound(2, unit, view.sum)};
    set_edges(view, shape, bounds, drafts);
    drafts.seen &= ~between_pixels(drafts);
    if (drafts.seen == 0) return;
    const Sixteen rho = shape.rho(corners.farthest, set_depths(view, away, drafts));
    const unsigned good = shape.agree & (rho <= Sixteen(most_rho));
    Sixteen::select(good, rho, infinite).store(drafts.rho);
    drafts.sane &= ~(drafts.regular & ~good);  // its edges hold in its span only
    drafts.regular &= good;
    const Sixteen reach =
        Sixteen::select(corners.ahead(view, shape), Sixteen(1.5f) * corners.farthest,
                        Sixteen(6 * view.size_w) * shape.size);
    bound_doubt(view, shape, reach, rho, most(bounds), drafts);
}

LUCH_INLINE void draft(const View& view, const Block& block, Drafts& drafts) {
    const Shape shape(view, block, drafts);
    const unsigned used = (1u << block.count) - 1;
    drafts.sane = shape.sane;
    drafts.seen = used & in_sight(view, shape);
    drafts.turned = view.cull_backfaces ? Sixteen(0.0f) < shape.volume : 0;
    if (drafts.seen == 0) return;
    place(view, shape, drafts);
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
