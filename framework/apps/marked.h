#pragma once

#include "framework/technique/technique.h"

#include <memory>
#include <string>

namespace luch {

/// A place on a frame: the pixels x, y of a frame of the size `of`.
struct MarkedPixel {
    int x = 0, y = 0;
    Size of;
};

/// "41,17" of a frame of that size. Throws Error that names the option when it says something else
/// or lies outside.
MarkedPixel parsed_pixel(const std::string& text, Size of);

/// The same technique, with squares drawn around that place of every frame, of whatever size.
std::unique_ptr<Technique> marked(std::unique_ptr<Technique> technique, const MarkedPixel& pixel);

}  // namespace luch
