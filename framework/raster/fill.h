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

template <Kind kind>
class Filler {
 public:
    /// (x, y): the bin's first pixel; all: rivals are wanted that are certainly farther, too.
    LUCH_INLINE Filler(const Facet& facet, int x, int y, bool all, Cell* cells)
        : facet_(facet),
          all_(all),
          cells_(cells),
          x_(x - static_cast<int>(facet.x)),
          y_(y - static_cast<int>(facet.y)),
          edge_{Plane(facet.edge[0]), Plane(facet.edge[1]), Plane(facet.edge[2])},
          depth_(facet.depth),
          item_(std::bit_cast<float>(facet.item)) {}

    LUCH_INLINE void fill(const Span& s) {
        const int x0 = std::max<int>(s.x0, 0) >> 2, y0 = std::max<int>(s.y0, 0) >> 2;
        const int x1 = std::min<int>(s.x1, bin_side - 1) >> 2;
        const int y1 = std::min<int>(s.y1, bin_side - 1) >> 2;
        if ((x1 - x0 + 1) * (y1 - y0 + 1) > 6) return descend(x0, y0, x1, y1);
        for (int y = y0; y <= y1; ++y) {
            for (int x = x0; x <= x1; ++x) {
                const int tile = (y >> 2) * 4 + (x >> 2), cell = (y & 3) * 4 + (x & 3);
                paint(cells_[tile * 16 + cell], x_ + 4 * x, y_ + 4 * y);
            }
        }
    }

 private:
    /// The span in cells.
    LUCH_INLINE void descend(int x0, int y0, int x1, int y1) {
        unsigned tiles = touched(x0 >> 2, y0 >> 2, x1 >> 2, y1 >> 2) & squares(x_, y_, 16);
        for (; tiles != 0; tiles &= tiles - 1) {
            const int tile = std::countr_zero(tiles);
            const int cx = (tile & 3) * 4, cy = (tile >> 2) * 4;
            const int x = x_ + 4 * cx, y = y_ + 4 * cy;
            unsigned cells = touched(x0 - cx, y0 - cy, x1 - cx, y1 - cy) & squares(x, y, 4);
            for (; cells != 0; cells &= cells - 1) {
                const int cell = std::countr_zero(cells);
                paint(cells_[tile * 16 + cell], x + 4 * (cell & 3), y + 4 * (cell >> 2));
            }
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

    LUCH_INLINE void paint(Cell& cell, int left, int top) const {
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
        if (maybe == 0) return;
        const Sixteen depth = depth_.at(x, y);
        Sixteen hi = depth * (1 + facet_.rho);
        if (maybe != certain) hi = Sixteen::select(certain, hi, in_doubt(depth, inner));
        const unsigned seen = maybe & (Sixteen::load(all_ ? cell.rival : cell.near) <= hi);
        if (seen == 0) return;
        const Sixteen rival = Sixteen::load(cell.rival), near = Sixteen::load(cell.near),
                      lo_depth = depth * (1 - facet_.rho);
        const unsigned wins = seen & certain & (near < lo_depth);
        if (wins == 0) {
            Sixteen::select(seen, max_or(hi, rival), rival).store(cell.rival);
            return;
        }
        const Sixteen near_most = Sixteen::load(cell.near_most);
        const Sixteen other = max_or(Sixteen::select(wins, near_most, hi), rival);
        Sixteen::select(seen, other, rival).store(cell.rival);
        Sixteen::select(wins, lo_depth, near).store(cell.near);
        Sixteen::select(wins, hi, near_most).store(cell.near_most);
        Sixteen::select(wins, item_, Sixteen::load(cell.item)).store(cell.item);
    }

    LUCH_INLINE Sixteen in_doubt(const Sixteen& depth, unsigned inner) const {
        if (!(facet_.doubt < 0)) return facet_.doubt;
        const Sixteen hi = (depth + Sixteen(-facet_.doubt)) * (1 + facet_.rho);
        return kind == Kind::regular ? hi : Sixteen::select(inner, hi, infinite);
    }

    const Facet& facet_;
    bool all_;
    Cell* cells_;
    int x_, y_;
    Plane edge_[3], depth_;
    float item_;
};

LUCH_INLINE void clear(Cell* cells) {
    const Sixteen zero(0.0f), none(std::bit_cast<float>(no_item));
    for (int i = 0; i < cells_of_bin; ++i) {
        zero.store(cells[i].near);
        zero.store(cells[i].near_most);
        zero.store(cells[i].rival);
        none.store(cells[i].item);
    }
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
    Cell cells[cells_of_bin];
    const bool all = second != nullptr;
    clear(cells);
    for (int i = 0; i < count; ++i) {
        const Entry& entry = entries[i];
        switch (entry.facet->kind) {
            case Kind::regular:
                Filler<Kind::regular>(*entry.facet, x, y, all, cells).fill(entry.span);
                break;
            case Kind::crossing:
                Filler<Kind::crossing>(*entry.facet, x, y, all, cells).fill(entry.span);
                break;
            case Kind::turned:
                Filler<Kind::turned>(*entry.facet, x, y, all, cells).fill(entry.span);
                break;
            case Kind::doubtful:
                Filler<Kind::doubtful>(*entry.facet, x, y, all, cells).fill(entry.span);
                break;
        }
    }
    write(cells, near, second, items);
}

}  // namespace
}  // namespace luch::raster
