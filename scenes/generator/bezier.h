#pragma once

#include "framework/math/vec.h"

#include <array>

namespace luch::assets {

/// A bicubic Bézier patch: rows[i][j] is the control point with Bernstein weights B_i(v)·B_j(u).
/// Positions and derivatives as in Farin, Curves and Surfaces for CAGD, chapter 14.
struct Patch {
    using Row = std::array<Vec3d, 4>;
    std::array<Row, 4> rows;

    [[nodiscard]] Vec3d point(double u, double v) const;
    [[nodiscard]] Vec3d du(double u, double v) const;
    [[nodiscard]] Vec3d dv(double u, double v) const;
    /// The mixed second derivative ∂²P/∂u∂v.
    [[nodiscard]] Vec3d duv(double u, double v) const;

    /// ∂P/∂v × ∂P/∂u, of length 1. Where a whole row of control points is one point, ∂P/∂u is zero
    /// there and the limit is taken instead: ∂P/∂u grows as ∂²P/∂u∂v times the distance from that
    /// row.
    [[nodiscard]] Vec3d normal(double u, double v) const;
};

}  // namespace luch::assets
