#include "techniques/layered/confusion.h"

#include <algorithm>

namespace luch::techniques::layered {

double signed_radius_px(double z, const Lens& lens) {
    if (!(lens.radius > 0)) return 0;
    const double most = lens.largest_px / 2;
    if (!(z > 0)) return most;
    const double radius = lens.radius * lens.px_per_unit * (1 / z - 1 / lens.focal_distance);
    return std::clamp(radius, -most, most);
}

}  // namespace luch::techniques::layered
