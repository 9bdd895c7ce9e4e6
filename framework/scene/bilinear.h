#pragma once

#include "framework/math/size.h"

#include <cmath>

namespace luch {

/// The part after the floor, in [0, 1); 0 where there is none (an infinite or NaN coordinate).
[[nodiscard]] inline double fraction_of(double x) {
    const double part = x - std::floor(x);
    return part < 1 ? part : 0;
}

/// The pixel at (s·W, t·H) of an image that repeats: bilinear between the pixel there and its right
/// and lower neighbours, without the half-texel shift. `at(x, y)` is a pixel of it.
template <class T, class At>
[[nodiscard]] T bilinear(Size size, double s, double t, At&& at) {
    if (size.area() == 0) return T(0);
    const double x = fraction_of(s) * size.width;
    const double y = fraction_of(t) * size.height;
    const int x0 = static_cast<int>(x) % size.width;
    const int y0 = static_cast<int>(y) % size.height;
    const int x1 = (x0 + 1) % size.width;
    const int y1 = (y0 + 1) % size.height;
    const auto fx = static_cast<float>(x - std::floor(x));
    const auto fy = static_cast<float>(y - std::floor(y));
    return (at(x0, y0) * (1 - fx) + at(x1, y0) * fx) * (1 - fy) +
           (at(x0, y1) * (1 - fx) + at(x1, y1) * fx) * fy;
}

}  // namespace luch
