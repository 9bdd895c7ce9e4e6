#pragma once

#include "framework/image/image.h"
#include "framework/window/pixel.h"

#include <string>
#include <vector>

namespace luch {

/// All that is to be seen in the window.
struct Composition {
    Size window;
    Size frame;                           ///< its proportions are kept, whatever the window's are
    const Image<Pixel>* left = nullptr;   ///< of any resolution; none: black
    const Image<Pixel>* right = nullptr;  ///< none: `left` fills the frame
    double split = 0.5;                   ///< where the right one begins, 0..1 of the frame's width
    std::string left_label = {}, right_label = {};  ///< shown while there are two pictures
    std::vector<std::string> status = {};           ///< along the bottom; wrapped
    std::string trouble = {};                       ///< below it, in red; wrapped
    std::vector<std::string> help = {};             ///< in the middle, over everything; "key\ttext"
};

/// The largest rectangle of the frame's proportions inside the window, centred. Empty when either
/// is.
Tile frame_area(Size window, Size frame);

/// The column of the window at which the right picture begins: area.x0 … area.x1.
int split_column(Tile area, double split);

/// Draws it. The picture on the left fills the columns before the split, that on the right those
/// after it; the split's own column is a white line.
Image<Pixel> composed(const Composition& composition);

}  // namespace luch
