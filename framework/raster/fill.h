#pragma once

#include "framework/raster/set_up.h"

#include <cstring>

// Facets into the cells of a bin: sixteen tiles at a time, then the sixteen cells of a tile, then
// the sixteen pixels of a cell. Only kernel files include this; nothing here has linkage.
namespace luch::raster {
namespace {

/// Columns and rows of the lanes.
alignas(64) inline constexpr float column[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) inline constexpr float row[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

/// A linear function, base + x · dx + y · dy, from the facet's anchor.
struct Plane {
    Sixteen lanes;  ///< at the pixels of a cell, without the base
    float base, dx, dy;

    LUCH_INLINE explicit Plane(const float (&f)[3])
        : lanes(Sixteen::load(column) * f[1] + Sixteen::load(row) * f[2]),
          base(f[0]),
          dx(f[1]),
          dy(f[2]) {}
    LUCH_INLINE Sixteen at(float x, float y) const { return lanes + (base + (x * dx + y * dy)); }
    /// At the first pixels of sixteen squares of the given side, the first one at (x, y).
    LUCH_INLINE Sixteen corners(float x, float y, float side) const {
        return lanes * Sixteen(side) + (base + (x * dx + y * dy));
    }
    /// By how much it may grow, and shrink, within such a square.
    LUCH_INLINE float rise(float side) const {
        return (side - 1) * (std::max(dx, 0.0f) + std::max(dy, 0.0f));
    }
    LUCH_INLINE float fall(float side) const {
        return (side - 1) * (std::min(dx, 0.0f) + std::min(dy, 0.0f));
    }
};

/// The bits of those of sixteen squares in rows of four that a span, counted in squares, touches.
LUCH_INLINE unsigned touched(int x0, int y0, int x1, int y1) {
    const auto range = [](int lo, int hi) {
        return (2u << std::min(hi, 3)) - (1u << std::max(lo, 0));
    };
    if (x1 < 0 || y1 < 0 || x0 > 3 || y0 > 3) return 0;
    const unsigned columns = range(x0, x1), rows = range(y0, y1);
    unsigned bits = 0;
    for (int y = 0; y < 4; ++y) bits |= (rows >> y & 1) != 0 ? columns << (4 * y) : 0;
    return bits;
}

/// A bin while it is drawn.
struct Bin {
    Cell cells[cells_of_bin];
    // No `near` of a cell, nor of a tile's cells, is less:
    alignas(64) float cell_near[cells_of_bin];
    alignas(64) float tile_near[16];
};

LUCH_INLINE float least_lane(const Sixteen& v) {
    return -largest_lane(Sixteen(0.0f) - v);
}

/// What no `hi` of paint() exceeds in a rectangle of pixels: its farthest inverse depth is found
/// from another corner, which is off by less than 2⁻²⁰ of the size of its parts. Of regular facets;
/// others are never hidden.
struct Ceiling {
    float more, factor, least;

    LUCH_INLINE Ceiling(const Facet& facet, int left, int top) {
        const auto farther = [](int from) {
            return static_cast<float>(std::max(std::abs(from), std::abs(from + bin_side)));
        };
        const float shift = facet.doubt < 0 ? -facet.doubt : 0;
        const float parts = std::abs(facet.depth[0]) + farther(left) * std::abs(facet.depth[1]) +
                            farther(top) * std::abs(facet.depth[2]);
        more = shift + 0x1p-20f * (parts + shift);
        factor = 1 + facet.rho;
        least = facet.doubt < 0 ? 0 : facet.doubt;
    }
    template <class T>
    LUCH_INLINE T over(const T& depth) const {
        return (depth + T(more)) * T(factor);
    }
};

template <Kind kind>
class Filler {
 public:
    /// (x, y): the bin's first pixel; all: rivals are wanted that are certainly farther, too.
    LUCH_INLINE Filler(const Facet& facet, int x, int y, bool all, Bin& bin)
        : facet_(facet),
          all_(all),
          bin_(bin),
          x_(x - static_cast<int>(facet.x)),
          y_(y - static_cast<int>(facet.y)),
          edge_{Plane(facet.edge[0]), Plane(facet.edge[1]), Plane(facet.edge[2])},
          depth_(facet.depth),
          ceiling_(facet, x_, y_),
          item_(std::bit_cast<float>(facet.item)) {}

    LUCH_INLINE void fill(const Span& s) {
        const int x0 = std::max<int>(s.x0, 0) >> 2, y0 = std::max<int>(s.y0, 0) >> 2;
        const int x1 = std::min<int>(s.x1, bin_side - 1) >> 2;
        const int y1 = std::min<int>(s.y1, bin_side - 1) >> 2;
        if ((x1 - x0 + 1) * (y1 - y0 + 1) > 6) return descend(x0, y0, x1, y1);
        const float highest = highest_in(x0, y0, x1, y1);
        for (int y = y0; y <= y1; ++y) {
            for (int x = x0; x <= x1; ++x) {
                const int tile = (y >> 2) * 4 + (x >> 2), cell = (y & 3) * 4 + (x & 3);
                if (highest < bin_.cell_near[tile * 16 + cell]) continue;
                paint(tile * 16 + cell, x_ + 4 * x, y_ + 4 * y);
            }
        }
    }

 private:
    static constexpr bool may_hide = kind == Kind::regular;

    /// What no pixel of some cells can exceed.
    LUCH_INLINE float highest_in(int x0, int y0, int x1, int y1) const {
        if (!may_hide || all_) return infinite;
        const auto x = static_cast<float>(x_ + 4 * x0), y = static_cast<float>(y_ + 4 * y0);
        const auto width = static_cast<float>(4 * (x1 - x0) + 3);
        const auto height = static_cast<float>(4 * (y1 - y0) + 3);
        const float depth =
            depth_.base + (x * depth_.dx + y * depth_.dy) +
            (width * std::max(depth_.dx, 0.0f) + height * std::max(depth_.dy, 0.0f));
        return std::max(ceiling_.over(depth), ceiling_.least);
    }

    /// Those of sixteen squares in which all that may be seen is behind what is there.
    LUCH_INLINE unsigned hidden(int left, int top, float side, const float* near) const {
        if (!may_hide || all_) return 0;
        const Sixteen corners =
            depth_.corners(static_cast<float>(left), static_cast<float>(top), side);
        const Sixteen highest = ceiling_.over(corners + depth_.rise(side));
        return max_or(highest, ceiling_.least) < Sixteen::load(near);
    }

    /// The span in cells.
    LUCH_INLINE void descend(int x0, int y0, int x1, int y1) {
        unsigned tiles = touched(x0 >> 2, y0 >> 2, x1 >> 2, y1 >> 2) & squares(x_, y_, 16) &
                         ~hidden(x_, y_, 16, bin_.tile_near);
        for (; tiles != 0; tiles &= tiles - 1) {
            const int tile = std::countr_zero(tiles);
            const int cx = (tile & 3) * 4, cy = (tile >> 2) * 4;
            const int x = x_ + 4 * cx, y = y_ + 4 * cy;
            float* near = bin_.cell_near + 16 * tile;
            unsigned cells = touched(x0 - cx, y0 - cy, x1 - cx, y1 - cy) & squares(x, y, 4) &
                             ~hidden(x, y, 4, near);
            unsigned nearer = 0;
            for (; cells != 0; cells &= cells - 1) {
                const int cell = std::countr_zero(cells);
                nearer |= paint(tile * 16 + cell, x + 4 * (cell & 3), y + 4 * (cell >> 2));
            }
            if (nearer != 0) bin_.tile_near[tile] = least_lane(Sixteen::load(near));
        }
    }

    /// Which of sixteen squares the triangle may touch.
    LUCH_INLINE unsigned squares(int left, int top, float side) const {
        const auto x = static_cast<float>(left), y = static_cast<float>(top);
        Sixteen hi(infinite), lo(-infinite);
        for (const Plane& edge : edge_) {
            const Sixteen at = edge.corners(x, y, side);
            hi = min_or(at + edge.rise(side), hi);
            lo = max_or(at + edge.fall(side), lo);
        }
        const unsigned outside = hi < Sixteen(-far_outside);
        if (kind == Kind::regular) return ~outside & 0xffff;
        const unsigned inside = Sixteen(far_outside) < lo;
        return (kind == Kind::turned ? ~inside : ~(outside & inside)) & 0xffff;
    }

    /// Gives the pixels whose nearest hit it is now.
    LUCH_INLINE unsigned paint(int number, int left, int top) {
        Cell& cell = bin_.cells[number];
        const auto x = static_cast<float>(left), y = static_cast<float>(top);
        const Sixteen e0 = edge_[0].at(x, y), e1 = edge_[1].at(x, y), e2 = edge_[2].at(x, y);
        const Sixteen lo = min_or(e0, min_or(e1, e2));
        const unsigned inner = Sixteen(-1.0f) <= lo;
        unsigned maybe = inner;
        unsigned certain = 0;
        if (kind == Kind::regular || kind == Kind::crossing) certain = Sixteen(1.0f) < lo;
        if (kind != Kind::regular) {
            const Sixteen hi = max_or(e0, max_or(e1, e2));
            const unsigned above = Sixteen(1.0f) < hi;
            if (kind == Kind::doubtful) maybe |= ~above & 0xffff;
            if (kind == Kind::crossing) maybe |= ~above & (Sixteen(-1.0f) <= hi);
            if (kind == Kind::turned) maybe = ~above & (Sixteen(-1.0f) <= hi);
        }
        if (maybe == 0) return 0;
        const Sixteen depth = depth_.at(x, y);
        Sixteen hi = depth * (1 + facet_.rho);
        if (maybe != certain) hi = Sixteen::select(certain, hi, in_doubt(depth, inner));
        const unsigned seen = maybe & (Sixteen::load(all_ ? cell.rival : cell.near) <= hi);
        if (seen == 0) return 0;
        const Sixteen rival = Sixteen::load(cell.rival), near = Sixteen::load(cell.near),
                      lo_depth = depth * (1 - facet_.rho);
        const unsigned wins = seen & certain & (near < lo_depth);
        if (wins == 0) {
            Sixteen::select(seen, max_or(hi, rival), rival).store(cell.rival);
            return 0;
        }
        const Sixteen near_most = Sixteen::load(cell.near_most);
        const Sixteen other = max_or(Sixteen::select(wins, near_most, hi), rival);
        Sixteen::select(seen, other, rival).store(cell.rival);
        const Sixteen nearest = Sixteen::select(wins, lo_depth, near);
        nearest.store(cell.near);
        bin_.cell_near[number] = least_lane(nearest);
        Sixteen::select(wins, hi, near_most).store(cell.near_most);
        Sixteen::select(wins, item_, Sixteen::load(cell.item)).store(cell.item);
        return wins;
    }

    LUCH_INLINE Sixteen in_doubt(const Sixteen& depth, unsigned inner) const {
        if (!(facet_.doubt < 0)) return facet_.doubt;
        const Sixteen hi = (depth + Sixteen(-facet_.doubt)) * (1 + facet_.rho);
        return kind == Kind::regular ? hi : Sixteen::select(inner, hi, infinite);
    }

    const Facet& facet_;
    bool all_;
    Bin& bin_;
    int x_, y_;
    Plane edge_[3], depth_;
    Ceiling ceiling_;
    float item_;
};

LUCH_INLINE void clear(Bin& bin) {
    const Sixteen zero(0.0f), none(std::bit_cast<float>(no_item));
    for (Cell& cell : bin.cells) {
        zero.store(cell.near);
        zero.store(cell.near_most);
        zero.store(cell.rival);
        none.store(cell.item);
    }
    std::fill(bin.cell_near, bin.cell_near + cells_of_bin, 0.0f);
    zero.store(bin.tile_near);
}

LUCH_INLINE void write(const Cell* cells, float* near, float* second, std::uint32_t* items) {
    for (int i = 0; i < cells_of_bin; ++i) {
        const Cell& cell = cells[i];
        const Sixteen depth = Sixteen::load(cell.near), rival = Sixteen::load(cell.rival);
        std::memcpy(items + 16 * i, cell.item, sizeof cell.item);
        unsigned ambiguous = (depth <= rival) & (Sixteen(0.0f) < rival);
        for (; ambiguous != 0; ambiguous &= ambiguous - 1) {
            items[16 * i + std::countr_zero(ambiguous)] |= ambiguous_bit;
        }
        if (near != nullptr) std::memcpy(near + 16 * i, cell.near, sizeof cell.near);
        if (second != nullptr) std::memcpy(second + 16 * i, cell.rival, sizeof cell.rival);
    }
}

void draw(const Entry* entries, int count, int x, int y, float* near, float* second,
          std::uint32_t* items) {
    if (count == 0) {
        std::fill(items, items + pixels_of_bin, no_item);
        if (near != nullptr) std::fill(near, near + pixels_of_bin, 0.0f);
        if (second != nullptr) std::fill(second, second + pixels_of_bin, 0.0f);
        return;
    }
    Bin bin;
    const bool all = second != nullptr;
    clear(bin);
    for (int i = 0; i < count; ++i) {
        const Entry& entry = entries[i];
        switch (entry.facet->kind) {
            case Kind::regular:
                Filler<Kind::regular>(*entry.facet, x, y, all, bin).fill(entry.span);
                break;
            case Kind::crossing:
                Filler<Kind::crossing>(*entry.facet, x, y, all, bin).fill(entry.span);
                break;
            case Kind::turned:
                Filler<Kind::turned>(*entry.facet, x, y, all, bin).fill(entry.span);
                break;
            case Kind::doubtful:
                Filler<Kind::doubtful>(*entry.facet, x, y, all, bin).fill(entry.span);
                break;
        }
    }
    write(bin.cells, near, second, items);
}

}  // namespace
}  // namespace luch::raster
