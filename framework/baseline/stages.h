#pragma once

#include "framework/scene/scene.h"
#include "framework/technique/plan.h"
#include "framework/technique/technique.h"
#include "framework/trace/parts.h"

namespace luch {

/// The stages of classic ray tracing and which of them a scene does not need, from one look at
/// scene, camera and settings. A technique that shades as the baseline does starts its plan with
/// these.
std::vector<Stage> classic_stages(const Scene& scene, const Shot& shot);

/// The stages of path tracing.
std::vector<Stage> path_stages(const Scene& scene, const Shot& shot);

/// A plan as switches for the hot code. A part that is no stage of it is needed.
Needs needs_of(const Plan& plan);

/// Whether the scene's own anti-aliasing has a say in a shot: the number of samples is not given,
/// and there are no lens samples, which lie all over the pixel.
bool may_antialias(const Shot& shot);

}  // namespace luch
