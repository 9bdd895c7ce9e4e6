#pragma once

#include "techniques/sh_ambient/sh_ambient.h"

namespace luch::techniques::sh_ambient {

/// What a scene's sky sends, projected.
struct SkyLight {
    Sh9 light;                 ///< as it was projected, degree 2
    std::uint64_t texels = 0;  ///< that were looked at
    std::uint64_t wild = 0;    ///< of them, not finite
    /// For each degree, how much it can change irradiance anywhere, relative to the mean over all
    /// normals: A_l·√((2l+1)/4π)·|L_l|, by Cauchy's inequality, since Σ_m Y_lm² = (2l+1)/4π.
    std::array<double, 3> strength{};

    [[nodiscard]] bool black() const { return strength[0] == 0; }
};

/// The environment's, else that of the background's colour.
SkyLight sky_light_of(const Scene& scene, const Steps& steps);

/// The same up to a degree, and with degree 1 scaled as wanted.
[[nodiscard]] Sh9 tamed(const Sh9& light, int degree, Ringing ringing);

}  // namespace luch::techniques::sh_ambient
