#pragma once

#include "framework/math/colour.h"
#include "framework/math/size.h"

namespace luch {

/// The block GlobalSettings: what a scene asks of whoever renders it.
struct Settings {
    Size frame{800, 600};
    Rgb ambient_light{0.15f};
    Rgb background{0};
    int max_depth = 8;  ///< a ray of greater depth is black; the camera ray has depth 0
    bool anti_aliasing = true;
    bool global_illumination = false;
    int paths = 32;   ///< per pixel, with global illumination
    int threads = 0;  ///< 0: all
};

}  // namespace luch
