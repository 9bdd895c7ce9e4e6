#include "framework/technique/outcome.h"

#include <algorithm>

namespace luch {

NonFinite non_finite_pixels(ImageView<const Rgb> image) {
    NonFinite result;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (all_finite(image(x, y))) continue;
            if (result.count++ == 0) {
                result.first_x = x;
                result.first_y = y;
            }
        }
    }
    return result;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace luch
