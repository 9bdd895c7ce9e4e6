#include "framework/measure/paired.h"

#include "framework/base/error.h"

#include <fmt/format.h>

#include <limits>

namespace luch {

void check_sizes(Size reference, Size image) {
    if (reference == image) return;
    throw Error(fmt::format("the images differ in size, {}x{} and {}x{}: compare two of one size",
                            reference.width, reference.height, image.width, image.height));
}

FinitePair finite_pair(ImageView<const Rgb> reference, ImageView<const Rgb> image) {
    check_sizes(reference.size(), image.size());
    FinitePair pair{Image<Rgb>(image.size()), Image<Rgb>(image.size()),
                    Image<std::uint8_t>(image.size()), 0};
    for (std::size_t i = 0; i < image.size().area(); ++i) {
        const Rgb &r = reference.data()[i], &v = image.data()[i];
        const bool r_fine = all_finite(r), v_fine = all_finite(v);
        pair.reference.pixels()[i] = r_fine ? r : v_fine ? v : Rgb(0);
        pair.image.pixels()[i] = v_fine ? v : r_fine ? r : Rgb(0);
        pair.kept.pixels()[i] = r_fine && v_fine ? 1 : 0;
        pair.count += pair.kept.pixels()[i];
    }
    return pair;
}

double mean_of_kept(const FinitePair& pair, Image<float>& map) {
    double sum = 0;
    for (std::size_t i = 0; i < map.pixels().size(); ++i) {
        if (pair.kept.pixels()[i] != 0) {
            sum += static_cast<double>(map.pixels()[i]);
        } else {
            map.pixels()[i] = std::numeric_limits<float>::quiet_NaN();
        }
    }
    return pair.count == 0 ? std::numeric_limits<double>::quiet_NaN()
                           : sum / static_cast<double>(pair.count);
}

}  // namespace luch
