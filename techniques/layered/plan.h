#pragma once

#include "techniques/layered/layered.h"

namespace luch::techniques::layered {

/// Names of the technique's own stages.
namespace stage {
inline constexpr std::string_view blur = "blur", behind = "behind", raster = "item buffer",
                                  thin = "thin layers", small = "small blur",
                                  detail = "blurred detail";
}

/// Circles of confusion of this many pixels leave no detail within one.
inline constexpr float lit_once_px = 8;

/// Whether the sky has one colour, so that it does not matter how it is blurred.
bool sky_is_plain(const Scene& scene);

/// Is there a lens to look through, and what of it does this shot need?
Plan plan_of(const Scene& scene, const Shot& shot, const Params& params);

}  // namespace luch::techniques::layered
