#include "framework/measure/flicker.h"

#include "framework/measure/paired.h"

#include <limits>

namespace luch {

void Flicker::add(ImageView<const Rgb> reference, ImageView<const Rgb> image) {
    check_sizes(reference.size(), image.size());
    const bool first = error_.size() == Size{};
    if (!first) check_sizes(error_.size(), image.size());
    Image<Vec3d> error(image.size());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            error(x, y) = Vec3d(image(x, y)) - Vec3d(reference(x, y));
            if (!all_finite(error(x, y)) && non_finite_.count++ == 0) {
                non_finite_.first_x = x;
                non_finite_.first_y = y;
            }
            if (first) continue;
            const Vec3d change = error(x, y) - error_(x, y);
            if (!all_finite(change)) continue;
            sum_ += std::abs(change.x) + std::abs(change.y) + std::abs(change.z);
            channels_ += 3;
        }
    }
    error_ = std::move(error);
}

double Flicker::mean() const {
    return channels_ == 0 ? std::numeric_limits<double>::quiet_NaN()
                          : sum_ / static_cast<double>(channels_);
}

}  // namespace luch
