#pragma once

#include "techniques/sh_ambient/probe_grid.h"

// Nine terms ring: of a small bright light they make irradiance below 0 on the far side (down to
// −0.03958 where a unit light gives at most 1). Scaling degree 1 mends that; windows that also
// weaken degree 2 do not.
namespace luch::techniques::sh_ambient {

/// 3√5/8: with degree 1 scaled by it the irradiance of any light that is nowhere negative is ≥ 0.
/// For a unit light the least of 1/4 + s·c/2 + 5(3c² − 1)/32 over c = cos θ is 0 with this s.
inline constexpr double ringing_scale = 0.83852549156242118;

/// The least irradiance over all normals and colours: the least of c + b·n + nᵀAn on the unit
/// sphere. It is a lower bound, met to rounding: the largest value of the dual
/// c − λ − ¼·bᵀ(A + λ)⁻¹b where A + λ is positive (S. Boyd and L. Vandenberghe, "Convex
/// Optimization", 2004, appendix B.1: there is no gap, though A need not be positive).
[[nodiscard]] double least_irradiance(const Sh9& light);

/// The largest factor ≤ 1 of degree 1 with which irradiance is nowhere below 0, whatever rounding
/// does; about ringing_scale where none is, which takes light that is negative itself.
[[nodiscard]] double least_scaling(const Sh9& light);

/// Multiplies degree 1.
void scale_linear_terms(Sh9& light, double factor);

}  // namespace luch::techniques::sh_ambient
