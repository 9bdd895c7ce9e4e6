#include "framework/scene/environment.h"

namespace luch {
namespace {

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

CubePoint cube_point(const Vec3d& direction) {
    const Vec3d d = direction / max_norm(direction);
    const Vec3d size = glm::abs(d);
    if (size.x >= size.y && size.x >= size.z) {
        return d.x < 0 ? CubePoint{CubePoint::neg_x, d.z, -d.y}
                       : CubePoint{CubePoint::pos_x, -d.z, -d.y};
    }
    if (size.y >= size.z) {
        return d.y < 0 ? CubePoint{CubePoint::neg_y, d.x, -d.z}
                       : CubePoint{CubePoint::pos_y, d.x, d.z};
    }
    return d.z < 0 ? CubePoint{CubePoint::neg_z, d.x, d.y} : CubePoint{CubePoint::pos_z, d.x, -d.y};
}

Vec3d CubePoint::direction() const {
    switch (side) {
        case neg_x:
            return {-1, -t, s};
        case pos_x:
            return {1, -t, -s};
        case neg_y:
            return {s, -1, -t};
        case pos_y:
            return {s, 1, t};
        case neg_z:
            return {s, t, -1};
        default:
            return {s, -t, 1};
    }
}

Rgb CubemapEnvironment::radiance(const Vec3d& direction) const {
    if (!(max_norm(direction) > 0) || !all_finite(direction)) return Rgb(0);
    const CubePoint point = cube_point(direction);
    return sampled(sides[point.side], point.s, point.t);
}

}  // namespace luch
