#pragma once

#include "framework/image/image.h"
#include "framework/window/pixel.h"

#include <string>
#include <string_view>
#include <vector>

namespace luch {

/// Height of a line of text at scale 1, in pixels.
inline constexpr int line_height_px = 12;

/// Width of one line of text at a scale (a whole number of pixels for each of the font's), in
/// pixels. The font holds printable ASCII; every other byte is drawn as '?'.
int text_width(std::string_view line, int scale);

/// Writes one line, its top-left corner at (x, y); what falls outside is cut off.
void draw_text(ImageView<Pixel> picture, int x, int y, int scale, std::string_view line,
               Pixel colour);

/// The text cut into lines no wider than `width_px`, at blanks where there are any.
std::vector<std::string> wrapped(std::string_view text, int scale, int width_px);

/// Fills a rectangle, whatever of it lies inside, mixing in `opacity` (0..1) of the colour.
void fill(ImageView<Pixel> picture, Tile area, Pixel colour, float opacity = 1);

}  // namespace luch
