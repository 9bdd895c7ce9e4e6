#pragma once

#include "framework/baseline/deferred.h"
#include "framework/technique/frame.h"
#include "techniques/ldr/canvas.h"

namespace luch::techniques::ldr {

/// Makes the planes that a viewer can show, before threads draw into them.
void make_planes(Frame& frame);

/// Draws what the points' words are made of: "albedo", "light" (the sum of all lights), "others"
/// (highlights, sky, mirrors…), each in 255 levels; and "too bright", where a plane is above white.
void draw_planes(const DeferredPixels& pixels, const Look& look, Frame& frame);

}  // namespace luch::techniques::ldr
