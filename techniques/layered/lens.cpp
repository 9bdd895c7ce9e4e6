#include "techniques/layered/layered.h"

#include <cmath>

namespace luch::techniques::layered {

Lens lens_of(const Camera& camera, Size size) {
    const Screen screen(camera, size);
    // Twice the diagonal: such a disc covers the picture from each of its pixels.
    const double largest = 2 * std::hypot(size.width, size.height);
    return {camera.lens_radius(), camera.focal_distance, size.height / (2 * screen.half_height()),
            static_cast<float>(largest)};
}

}  // namespace luch::techniques::layered
