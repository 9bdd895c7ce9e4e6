#pragma once

#include "framework/base/json.h"
#include "framework/measure/report.h"

namespace luch {

// Parts that other verbs' JSON shares.

/// {primary, shadow, reflection, refraction, glossy, gi}.
Json rays_json(const Counts& counts);

/// Every metric by its name, then differing_pixels, non_finite and, where there is one, the place.
/// An infinite PSNR is null.
Json errors_json(const Errors& errors);

/// [{stage, exact, kind, why}] of what was left out.
Json left_out_json(const Plan& plan);

}  // namespace luch
