#include "framework/scene/environment.h"

namespace luch {
namespace {

/// Where a direction leaves the cube: the side, and s to the right and t down on it, in −1..1.
struct Spot {
    CubemapEnvironment::Side side;
    double s, t;
};

/// `d` has its largest component, of magnitude 1, on the side's axis. Ties go to x, then y.
Spot spot_on_cube(const Vec3d& d) {
    const Vec3d size = glm::abs(d);
    if (size.x >= size.y && size.x >= size.z) {
        return d.x < 0 ? Spot{CubemapEnvironment::neg_x, d.z, -d.y}
                       : Spot{CubemapEnvironment::pos_x, -d.z, -d.y};
    }
    if (size.y >= size.z) {
        return d.y < 0 ? Spot{CubemapEnvironment::neg_y, d.x, -d.z}
                       : Spot{CubemapEnvironment::pos_y, d.x, d.z};
    }
    return d.z < 0 ? Spot{CubemapEnvironment::neg_z, d.x, d.y}
                   : Spot{CubemapEnvironment::pos_z, d.x, -d.y};
}

/// Bilinear; (−1, −1) is the centre of the top-left pixel, (1, 1) that of the bottom-right one.
Rgb sampled(const Image<Rgb>& image, double s, double t) {
    if (image.size().area() == 0) return Rgb(0);
    const double x = (s + 1) / 2 * (image.width() - 1);
    const double y = (t + 1) / 2 * (image.height() - 1);
    const int x0 = static_cast<int>(x);
    const int y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, image.width() - 1);
    const int y1 = std::min(y0 + 1, image.height() - 1);
    const auto fx = static_cast<float>(x - x0);
    const auto fy = static_cast<float>(y - y0);
    return (image(x0, y0) * (1 - fx) + image(x1, y0) * fx) * (1 - fy) +
           (image(x0, y1) * (1 - fx) + image(x1, y1) * fx) * fy;
}

}  // namespace

Rgb CubemapEnvironment::radiance(const Vec3d& direction) const {
    const double size = max_norm(direction);
    if (!(size > 0) || !all_finite(direction)) return Rgb(0);
    const Spot spot = spot_on_cube(direction / size);
    return sampled(sides[spot.side], spot.s, spot.t);
}

}  // namespace luch
