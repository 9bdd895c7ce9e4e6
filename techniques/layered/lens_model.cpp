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

double signed_radius_px(double z, const Lens& lens) {
    if (!(lens.radius > 0)) return 0;
    const double most = lens.largest_px / 2;
    if (!(z > 0)) return most;
    const double radius = lens.radius * lens.px_per_unit * (1 / z - 1 / lens.focal_distance);
    return std::clamp(radius, -most, most);
}

}  // namespace luch::techniques::layered
