#pragma once

#include "framework/accel/wide/lanes.h"
#include "framework/accel/wide/split.h"
#include "framework/accel/wide/tree.h"

#include <utility>

// One step of the build: binning, choosing a plane, and sorting the refs to its sides (Wald, "On
// fast Construction of SAH-based Bounding Volume Hierarchies", 2007). Only kernel files include
// this; nothing here has linkage.
namespace luch::wide {
namespace {

using Corner = Lanes<4>;
inline constexpr int most_bins = 16;
inline constexpr unsigned xyz = 7;

struct Bin {
    Corner lo, hi;

    LUCH_INLINE void clear() {
        lo = Corner(std::numeric_limits<float>::infinity());
        hi = Corner(-std::numeric_limits<float>::infinity());
    }
    LUCH_INLINE void grow(const Corner& l, const Corner& h) {
        lo = min_or(l, lo);
        hi = max_or(h, hi);
    }
    LUCH_INLINE Corners corners() const {
        Corners c;
        lo.store(c.lo);
        hi.store(c.hi);
        return c;
    }
};

/// Where the centres fall: bin = (centre − from) · scale, in 0…bins − 1 even for NaN.
struct Binning {
    int bins;
    Corner from, scale;

    explicit Binning(const Range& range)
        : bins(std::min(most_bins, static_cast<int>(4 + range.count / 4))),
          from(Corner::load(range.centres.lo)) {
        const Corner width = Corner::load(range.centres.hi) - from;
        const Corner whole = Corner(static_cast<float>(bins)) / width;
        scale = Corner::select((Corner(0.0f) < width) & xyz, whole, 0.0f);
    }
    LUCH_INLINE void bins_of(const Corner& lo, const Corner& hi, int* bin) const {
        const Corner centre = Corner::select(xyz, lo + hi, 0.0f);
        const Corner last(static_cast<float>(bins - 1));
        const Corner at = min_or(max_or((centre - from) * scale, Corner(0.0f)), last);
        alignas(16) float f[4];
        at.store(f);
        for (int axis = 0; axis < 3; ++axis) bin[axis] = static_cast<int>(f[axis]);
    }
};

LUCH_INLINE Corner lo_of(const Ref& ref) {
    return Corner::load(ref.lo);
}
LUCH_INLINE Corner hi_of(const Ref& ref) {
    return Corner::load(ref.hi);
}

/// A leaf holds one block, so triangles are paid for by the block.
LUCH_INLINE float blocks(std::uint32_t count) {
    return static_cast<float>((count + block_width - 1) / block_width);
}

struct Plane {
    int axis = -1, bin = 0;
};

/// The cheapest plane by the surface area heuristic; axis −1 where none separates the centres.
inline Plane best_plane(const Ref* refs, const Range& range, const Binning& binning) {
    Bin bin[3][most_bins];
    std::uint32_t count[3][most_bins] = {};
    for (auto& axis : bin) {
        for (int i = 0; i < binning.bins; ++i) axis[i].clear();
    }
    for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
        const Corner lo = lo_of(refs[i]), hi = hi_of(refs[i]);
        int at[3];
        binning.bins_of(lo, hi, at);
        for (int axis = 0; axis < 3; ++axis) {
            bin[axis][at[axis]].grow(lo, hi);
            ++count[axis][at[axis]];
        }
    }
    Plane best;
    float best_cost = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (!(range.centres.hi[axis] > range.centres.lo[axis])) continue;
        float right[most_bins];
        Bin sum;
        sum.clear();
        std::uint32_t number = 0;
        for (int i = binning.bins - 1; i > 0; --i) {
            sum.grow(bin[axis][i].lo, bin[axis][i].hi);
            number += count[axis][i];
            right[i] = half_area(sum.corners()) * blocks(number);
        }
        sum.clear();
        number = 0;
        for (int i = 0; i + 1 < binning.bins; ++i) {
            sum.grow(bin[axis][i].lo, bin[axis][i].hi);
            number += count[axis][i];
            if (number == 0 || number == range.count) continue;
            const float cost = half_area(sum.corners()) * blocks(number) + right[i + 1];
            if (cost < best_cost) {
                best_cost = cost;
                best = {axis, i};
            }
        }
    }
    return best;
}

/// Bounds of one side while its refs are collected.
struct Side {
    Bin box, centres;
    Side() {
        box.clear();
        centres.clear();
    }
    LUCH_INLINE void grow(const Ref& ref) {
        const Corner lo = lo_of(ref), hi = hi_of(ref);
        box.grow(lo, hi);
        const Corner centre = lo + hi;
        centres.grow(centre, centre);
    }
    LUCH_INLINE Range range(std::uint32_t first, std::uint32_t count) const {
        return {first, count, box.corners(), centres.corners()};
    }
};

/// Sorts the refs to the sides of the cheapest plane, or where there is none (or `by_count` says
/// so) cuts them in two.
void split_range(Ref* refs, const Range& range, bool by_count, Range& left, Range& right) {
    Side below, above;
    const Binning binning(range);
    const Plane plane = by_count ? Plane{} : best_plane(refs, range, binning);
    std::uint32_t begin = range.first, end = range.first + range.count;
    if (plane.axis < 0) {
        const std::uint32_t middle = range.first + range.count / 2;
        for (; begin < middle; ++begin) below.grow(refs[begin]);
        for (std::uint32_t i = middle; i < end; ++i) above.grow(refs[i]);
    } else {
        while (begin < end) {
            int at[3];
            binning.bins_of(lo_of(refs[begin]), hi_of(refs[begin]), at);
            if (at[plane.axis] <= plane.bin) {
                below.grow(refs[begin++]);
            } else {
                above.grow(refs[begin]);
                std::swap(refs[begin], refs[--end]);
            }
        }
    }
    left = below.range(range.first, begin - range.first);
    right = above.range(begin, range.first + range.count - begin);
}

/// Bounds of all refs.
Range range_of(const Ref* refs, std::uint32_t count) {
    Side all;
    for (std::uint32_t i = 0; i < count; ++i) all.grow(refs[i]);
    return all.range(0, count);
}

}  // namespace
}  // namespace luch::wide
