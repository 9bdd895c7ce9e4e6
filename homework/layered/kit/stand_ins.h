#pragma once

#include "techniques/layered/layered.h"

namespace luch::techniques::layered {

/// Whether these are the depths of one of the homework's own scenes, at its own camera and size, or
/// those with what is nearer than the plane of focus moved there. There, reference() knows where to
/// cut and how large the circles are.
bool is_public(std::span<const float> depths);

}  // namespace luch::techniques::layered
