#pragma once

#include "techniques/vista/vista.h"

namespace luch::techniques::vista {

/// Does an item buffer do for this shot, and which of its stages does it need: "lod", "clip",
/// "sort" of the classic; "item buffer", "stand-ins", "lod" of exact mode?
Plan plan_of(const Scene& scene, const Shot& shot, const Params& params);

/// The radius in pixels that a node appears with; infinite when the eye is inside its bounding
/// sphere or the node has no end.
float radius_px(const Scene& scene, const Node& node, const Screen& screen);

}  // namespace luch::techniques::vista
