#include "techniques/shadow_map/cube.h"

namespace luch::techniques::shadow_map {
namespace {

/// A range of a coordinate on a face.
struct Range {
    double lo = 0, hi = 0;
};

/// What side/depth can be, for a side in [lo, hi] and a depth in (near, far]; near ≥ 0.
Range ratios(double lo, double hi, double near, double far) {
    const auto over = [&](double side, bool least) {
        const double depth = (side < 0) == least ? near : far;
        if (side == 0 || std::isinf(depth)) return std::isinf(side) ? side : 0.0;
        return side / depth;  // infinite over 0
    };
    return {std::clamp(over(lo, true), -1.0, 1.0), std::clamp(over(hi, false), -1.0, 1.0)};
}

/// The texels that a range of −1..1 touches, rounding included.
std::pair<int, int> cells(const Range& range, int n, int margin) {
    constexpr double slack = 0x1p-20;
    const double first = std::floor((range.lo - slack + 1) / 2 * n) - margin;
    const double last = std::floor((range.hi + slack + 1) / 2 * n) + margin;
    return {static_cast<int>(std::clamp(first, 0.0, double(n))),
            static_cast<int>(std::clamp(last + 1, 0.0, double(n)))};
}

}  // namespace

std::optional<Texel> folded_over(const Texel& place, int n) {
    // In units of half a texel, a centre on face z has the coordinates (a, b, n). Past the edge at
    // x = n it is at (n + 1, b, n), and folded over it at (n, b, n − 1): a centre of face x.
    const auto& [face, x, y] = place;
    const bool past_x = x < 0 || x >= n, past_y = y < 0 || y >= n;
    if (past_x && past_y) return std::nullopt;
    std::array<int, 3> centre{};
    centre[static_cast<std::size_t>(main_axis(face))] = face % 2 == 1 ? 1 - n : n - 1;
    centre[static_cast<std::size_t>(x_axis(face))] = 2 * x + 1 - n;
    centre[static_cast<std::size_t>(y_axis(face))] = 2 * y + 1 - n;
    const int over = past_x ? x_axis(face) : y_axis(face);
    const int onto = 2 * over + ((past_x ? x : y) < 0 ? 1 : 0);
    const auto cell = [&](int axis) {
        return (centre[static_cast<std::size_t>(axis)] + n - 1) / 2;
    };
    return Texel{onto, cell(x_axis(onto)), cell(y_axis(onto))};
}

Tile window_of(const Boxd& box, int face, int n, int margin) {
    const int axis = main_axis(face);
    const bool back = face % 2 == 1;
    const double far = back ? -box.lo[axis] : box.hi[axis];
    const double near = std::max(0.0, back ? -box.hi[axis] : box.lo[axis]);
    if (box.empty() || !(far >= 0)) return {};
    const auto range = [&](int side) {
        return ratios(box.lo[side], box.hi[side], near, std::max(far, near));
    };
    // Beside the face altogether: nothing of the box has |side| ≤ depth.
    for (const int side : {x_axis(face), y_axis(face)}) {
        constexpr double slack = 1 + 0x1p-20;
        if (box.lo[side] > far * slack || -box.hi[side] > far * slack) return {};
    }
    const auto [x0, x1] = cells(range(x_axis(face)), n, margin);
    const auto [y0, y1] = cells(range(y_axis(face)), n, margin);
    return x0 < x1 && y0 < y1 ? Tile{x0, y0, x1, y1} : Tile{};
}

Boxd directions_of(const SpotLight& light) {
    constexpr double slack = 0x1p-20;
    const double angle = std::acos(std::clamp(light.outer_cosine, -1.0, 1.0)) + slack;
    Boxd box;
    for (int axis = 0; axis < 3; ++axis) {
        const double middle = std::acos(std::clamp(light.direction[axis], -1.0, 1.0));
        box.lo[axis] = std::cos(std::min(middle + angle, std::acos(-1.0))) - slack;
        box.hi[axis] = std::cos(std::max(middle - angle, 0.0)) + slack;
    }
    return box;
}

}  // namespace luch::techniques::shadow_map
