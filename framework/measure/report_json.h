#pragma once

#include "framework/base/json.h"
#include "framework/measure/report.h"

namespace luch {

// Parts that other verbs' JSON shares.

/// {primary, shadow, reflection, refraction, glossy, gi}.
Json rays_json(const Counts& counts);

/// Adds every metric by its name (special ones where they are numbers), then flip_kind ("ldr",
/// "hdr"), differing_pixels, non_finite and, where there is one, the place of the largest error. An
/// infinite PSNR is null.
Json errors_json(const Errors& errors, Json object = Json::object());

/// [{stage, exact, kind, why}] of what was left out.
Json left_out_json(const Plan& plan);

}  // namespace luch
