#pragma once

#include "techniques/layered/layered.h"

namespace luch::techniques::layered {

/// The radius in pixels of the circle of confusion, with a sign: negative behind the plane of
/// focus. A point at depth z that the middle of the lens sees at pixel p is seen at p − c·u from
/// the point u of the lens's unit disc, where p is held fixed in the plane of focus.
double signed_radius_px(double z, const Lens& lens);

}  // namespace luch::techniques::layered
