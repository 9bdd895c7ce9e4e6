#pragma once

#include "framework/parallel/workers.h"
#include "framework/technique/frame.h"
#include "framework/window/pixel.h"

namespace luch {

/// The frame's colour as a screen shows it, made by all workers. A pixel that is not finite is
/// magenta, so that it is seen.
Image<Pixel> developed(const Frame& frame, const Workers& workers);

/// A plane in false colours: scalars from dark blue (least) through green to yellow (most), values
/// beyond clamped; ids each in a colour of its own, ~0 (none) black; normals n/2 + 1/2; masks black
/// and white; colours as they are. What is not finite is magenta.
Image<Pixel> developed(const Plane2d& plane);

/// Draws the marks' outlines; both pictures' coordinates are the same.
void draw_marks(ImageView<Pixel> picture, const std::vector<Mark>& marks);

}  // namespace luch
