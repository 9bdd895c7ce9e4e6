#pragma once

#include "techniques/shadow_map/shadow_map.h"

namespace luch::techniques::shadow_map {

/// Names of the technique's own stages.
namespace stage {
inline constexpr std::string_view maps = "shadow maps", empty_faces = "faces without receivers",
                                  convex = "lone convex thing", filter = "percentage-closer",
                                  raster = "rasterised maps", memory = "memory of maps";
}

/// Texels narrower than this many pixels need no filter.
inline constexpr float filtered_px = 0.5f;

/// Whether the scene is one sphere or cube, closed and smooth, with no light in it: it casts no
/// shadow on what faces the light.
bool is_lone_convex(const Scene& scene);

/// Whether light from a place can fall on anything.
bool has_receivers(const Scene& scene);

/// What of the technique does this shot need?
Plan plan_of(const Scene& scene, const Shot& shot, const Params& params);

}  // namespace luch::techniques::shadow_map
