#pragma once

#include "framework/technique/context.h"
#include "techniques/sh_ambient/sh_ambient.h"

namespace luch::techniques::sh_ambient {

/// A grid around all of a scene that has an end, in cells that are about cubes, without light: so
/// many probes along its longest side. Around the eye where all things are endless.
[[nodiscard]] ProbeGrid grid_around(const Scene& scene, const Vec3d& eye, int along);

/// No grid has more probes along a side.
inline constexpr int most_probes = 64;

/// Fills the grid: light for all probes, and distances where they are wanted. Any number of
/// threads, the same bits. Rays go through the context's tracers. False when it was cancelled.
bool fill(ProbeGrid& grid, const Scene& scene, const Params& params, const Needs& needs, Key key,
          const Steps& steps, Context& context);

}  // namespace luch::techniques::sh_ambient
