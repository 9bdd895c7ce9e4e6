#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

namespace luch::testing {

/// A picture of many edges and colours from whole numbers, so that it is the same elsewhere:
/// ((7x + 13y) mod 32)/31, ((x² + 3y) mod 17)/16, ((5x + y²) mod 23)/22.
inline Image<Rgb> pattern(Size size) {
    Image<Rgb> image(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            image(x, y) = Rgb(static_cast<float>((7 * x + 13 * y) % 32) / 31,
                              static_cast<float>((x * x + 3 * y) % 17) / 16,
                              static_cast<float>((5 * x + y * y) % 23) / 22);
        }
    }
    return image;
}

/// The same with red inverted where x + 2y is a multiple of 5, and half of its blue.
inline Image<Rgb> altered_pattern(Size size) {
    Image<Rgb> image = pattern(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if ((x + 2 * y) % 5 == 0) image(x, y).r = 1 - image(x, y).r;
            image(x, y).b *= 0.5f;
        }
    }
    return image;
}

inline Image<Rgb> transposed(const Image<Rgb>& image) {
    Image<Rgb> turned({image.height(), image.width()});
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) turned(y, x) = image(x, y);
    }
    return turned;
}

}  // namespace luch::testing
