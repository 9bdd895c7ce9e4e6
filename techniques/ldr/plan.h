#pragma once

#include "framework/technique/plan.h"
#include "techniques/ldr/ldr.h"

namespace luch::techniques::ldr {

// Stages of its own, beside those of the classic tracer.
inline constexpr std::string_view accumulator = "accumulator", wide_light = "wide light",
                                  tone_mapping = "tone mapping", word_textures = "word textures";

Plan plan_of(const Scene& scene, const Shot& shot, const Params& params);

/// Whether a stage is there and to be run; a user may have switched it off altogether.
bool runs(const Plan& plan, std::string_view stage);

}  // namespace luch::techniques::ldr
