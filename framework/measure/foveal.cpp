#include "framework/measure/foveal.h"

#include "framework/measure/paired.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace luch {
namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

double relative_acuity(double eccentricity_deg) {
    constexpr double half_resolution_deg = 2.3;
    return half_resolution_deg / (half_resolution_deg + eccentricity_deg);
}

double eccentricity_deg(Vec2d point, const Gaze& gaze, double pixels_per_degree) {
    const double distance_px = pixels_per_degree / degree;
    return std::atan(glm::distance(point, gaze.px) / distance_px) / degree;
}

double foveal_rmse(ImageView<const Rgb> reference, ImageView<const Rgb> image, const Gaze& gaze,
                   double pixels_per_degree) {
    check_sizes(reference.size(), image.size());
    double squares = 0, weights = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const Rgb &r = reference(x, y), &v = image(x, y);
            if (!all_finite(r) || !all_finite(v)) continue;
            const double acuity =
                relative_acuity(eccentricity_deg(Vec2d(x + 0.5, y + 0.5), gaze, pixels_per_degree));
            const Vec3d off = Vec3d(v) - Vec3d(r);
            squares += acuity * acuity * glm::dot(off, off);
            weights += acuity * acuity * 3;
        }
    }
    return weights > 0 ? std::sqrt(squares / weights) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace luch
