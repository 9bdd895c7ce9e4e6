#include "techniques/layered/planes.h"

#include <algorithm>
#include <cmath>

namespace luch::techniques::layered {
namespace {

/// Radii well below this are divided evenly, larger ones the more coarsely.
constexpr double bend_px = 24;

double bent(double radius_px) {
    return radius_px / (1 + std::abs(radius_px) / bend_px);
}

double straightened(double bent_px) {
    return bent_px / (1 - std::abs(bent_px) / bend_px);
}

}  // namespace

Planes::Planes(double near_px, double far_px, int count, bool merge)
    : first_(bent(near_px)), step_(0), count_(std::max(count, 1)) {
    const double range = first_ - bent(far_px);
    if (merge) {
        // Two radii are half as far apart as their diameters.
        const double finest = bent(merged_px / 2);
        count_ = std::min(count_, 1 + static_cast<int>(std::ceil(range / finest)));
    }
    if (count_ > 1) step_ = range / (count_ - 1);
    if (count_ == 1) first_ -= range / 2;
}

float Planes::position(double radius_px) const {
    if (!(step_ > 0)) return 0;
    return static_cast<float>(
        std::clamp((first_ - bent(radius_px)) / step_, 0.0, double(count_ - 1)));
}

double Planes::radius_px(int plane) const {
    const double at = first_ - plane * step_;
    if (std::abs(at) <= step_ / 2) return 0;
    return straightened(at);
}

}  // namespace luch::techniques::layered
