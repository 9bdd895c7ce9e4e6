#pragma once

#include "techniques/ssao/ssao.h"

namespace luch::techniques::ssao {

/// Names of the technique's own stages.
namespace stage {
inline constexpr std::string_view occlusion = "occlusion", convex = "convex things",
                                  small = "small radius";
}

/// Params::samples and radius, found where they are 0.
Params settled(const Params& params, const Scene& scene);

/// Is there ambient light to be kept away, and by what?
Plan plan_of(const Scene& scene, const Shot& shot, const Params& params);

}  // namespace luch::techniques::ssao
