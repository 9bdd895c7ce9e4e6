#include "techniques/shadow_map/cover.h"

#include <algorithm>

namespace luch::techniques::shadow_map {
namespace {

/// A few corners, without an allocation: six planes add one each to a triangle or a quad.
struct Corners {
    std::array<Vec3d, 12> at;
    std::size_t count = 0;

    void add(const Vec3d& corner) {
        if (count < at.size()) at[count++] = corner;
    }
};

/// The part of a convex polygon where inside(corner) ≥ 0, which is linear.
template <class Inside>
Corners clipped(const Corners& polygon, Inside&& inside) {
    Corners out;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Vec3d &a = polygon.at[i], &b = polygon.at[(i + 1) % polygon.count];
        const double of_a = inside(a), of_b = inside(b);
        if (of_a >= 0) out.add(a);
        if ((of_a >= 0) != (of_b >= 0)) out.add(a + of_a / (of_a - of_b) * (b - a));
    }
    return out;
}

/// What lies in the face's pyramid, wider by 2 pad: no direction through the face is lost.
Corners in_pyramid(FacePolygon polygon, double pad) {
    Corners out;
    for (const Vec3d& corner : polygon) out.add(corner);
    const double wider = 2 * pad;
    const bool inside = std::ranges::all_of(
        polygon, [](const Vec3d& p) { return std::abs(p.x) <= p.z && std::abs(p.y) <= p.z; });
    if (inside) return out;  // as most are
    out = clipped(out, [&](const Vec3d& p) { return p.z + wider - p.x; });
    out = clipped(out, [&](const Vec3d& p) { return p.z + wider + p.x; });
    out = clipped(out, [&](const Vec3d& p) { return p.z + wider - p.y; });
    out = clipped(out, [&](const Vec3d& p) { return p.z + wider + p.y; });
    return out;
}

/// The columns of a polygon's part between two rows.
struct Columns {
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    void grow(double x) {
        lo = std::min(lo, x);
        hi = std::max(hi, x);
    }
};

Columns columns_between(std::span<const Vec2d> polygon, double top, double bottom) {
    Columns columns;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if (std::max(a.y, b.y) < top || std::min(a.y, b.y) > bottom) continue;
        const auto at = [&](double y) {
            const double share = (y - a.y) / (b.y - a.y);
            return a.x + std::clamp(share, 0.0, 1.0) * (b.x - a.x);
        };
        const bool level = a.y == b.y;
        columns.grow(level || (a.y >= top && a.y <= bottom) ? a.x : at(a.y < top ? top : bottom));
        columns.grow(level || (b.y >= top && b.y <= bottom) ? b.x : at(b.y < top ? top : bottom));
    }
    return columns;
}

int clamped_floor(double x, int least, int most) {
    return static_cast<int>(std::clamp(std::floor(x), double(least), double(most)));
}

}  // namespace

bool cover(FacePolygon polygon, double pad, int n, const Tile& window, std::vector<Run>& runs) {
    runs.clear();
    const Corners in = in_pyramid(polygon, pad);
    if (in.count == 0) return true;
    double nearest = in.at[0].z;
    for (std::size_t i = 1; i < in.count; ++i) nearest = std::min(nearest, in.at[i].z);
    if (!(nearest > 8 * pad)) return false;

    // A point that is pad away is seen 3 pad/z away at most, as pad ≤ z/8.
    const double slack = n / 2.0 * (3 * pad / nearest + 0x1p-30);
    std::array<Vec2d, 12> seen;
    double top = std::numeric_limits<double>::infinity(), bottom = -top;
    for (std::size_t i = 0; i < in.count; ++i) {
        seen[i] = (Vec2d(in.at[i]) / in.at[i].z + 1.0) * (n / 2.0);
        top = std::min(top, seen[i].y);
        bottom = std::max(bottom, seen[i].y);
    }
    const int first = clamped_floor(top - slack, window.y0, window.y1);
    const int last = clamped_floor(bottom + slack, window.y0 - 1, window.y1 - 1);
    for (int y = first; y <= last; ++y) {
        const Columns columns = columns_between({seen.data(), in.count}, y - slack, y + 1 + slack);
        if (!(columns.lo <= columns.hi)) continue;
        const int x0 = clamped_floor(columns.lo - slack, window.x0, window.x1);
        const int x1 = clamped_floor(columns.hi + slack, window.x0 - 1, window.x1 - 1) + 1;
        if (x0 < x1) runs.push_back({y, x0, x1});
    }
    return true;
}

}  // namespace luch::techniques::shadow_map
