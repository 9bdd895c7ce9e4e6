#include "framework/scene/material.h"

#include <cmath>

namespace luch {

Rgb Refraction::transmittance(double distance) const {
    Rgb left(1);
    for (int k = 0; k < 3; ++k) {
        const double fading = absorption * (1 - static_cast<double>(inside_color[k]));
        if (fading != 0) left[k] = static_cast<float>(std::exp(-fading * distance));
    }
    return left;
}

}  // namespace luch
