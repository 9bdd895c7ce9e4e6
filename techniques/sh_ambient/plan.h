#pragma once

#include "techniques/sh_ambient/sky.h"

namespace luch::techniques::sh_ambient {

/// Names of the technique's own stages.
namespace stage {
inline constexpr std::string_view ambient = "ambient light", projection = "projection",
                                  wild = "wild texels", linear = "linear terms",
                                  quadratic = "quadratic terms", ringing = "ringing",
                                  probes = "probes", distances = "distances";
}

/// Terms that can change no irradiance by more than this share of the mean are left out: half a
/// step of a display of 8 bits where the mean is white.
inline constexpr double weak_terms = 1.0 / 512;

/// Is there ambient light, and what of it does this scene need?
Plan plan_of(const Scene& scene, const Shot& shot, const Params& params, const SkyLight& sky);

/// The degree that a plan leaves: of those wanted, the highest whose terms are needed.
int degree_left(const Plan& plan, const Params& params);

}  // namespace luch::techniques::sh_ambient
