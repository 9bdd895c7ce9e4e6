#include "framework/measure/flip.h"

#include "framework/measure/flip_colour.h"
#include "framework/measure/flip_filters.h"
#include "framework/measure/paired.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace luch {
namespace {

using flip::FilteredRow;

// Andersson et al. 2020, section 4.3: exponents, and where the colour error bends.
constexpr float colour_exponent = 0.7f, feature_exponent = 0.5f;
constexpr float bend_at = 0.4f, bend_to = 0.95f;

constexpr int band_rows = 64;  // more cost memory, fewer filter more rows twice

/// The largest distance of two colours in the display's gamut, after the exponent.
float largest_colour_error() {
    static const float largest = std::pow(
        flip::hyab(flip::hunt_lab(Rgb(0, 1, 0)), flip::hunt_lab(Rgb(0, 0, 1))), colour_exponent);
    return largest;
}

/// 0..1: small distances take most of that range, since they are what people argue about.
float colour_error(const Rgb& reference, const Rgb& image) {
    if (reference == image) return 0;  // as it would be; most pixels of most pairs are equal
    const float distance =
        std::pow(flip::hyab(flip::hunt_lab(reference), flip::hunt_lab(image)), colour_exponent);
    const float largest = largest_colour_error(), bend = bend_at * largest;
    if (distance < bend) return bend_to / bend * distance;
    return bend_to + (distance - bend) / (largest - bend) * (1 - bend_to);
}

/// How much more or less of an edge or a point there is, 0..1.
float feature_error(const FilteredRow& reference, const FilteredRow& image, std::size_t x) {
    const float edge = std::abs(reference.edge[x] - image.edge[x]);
    const float point = std::abs(reference.point[x] - image.point[x]);
    return std::pow(std::max(edge, point) * std::sqrt(0.5f), feature_exponent);
}

/// The error map of two images of linear light in 0..1.
Image<float> error_map(ImageView<const Rgb> reference, ImageView<const Rgb> image,
                       const flip::Kernels& kernels, const Workers& workers) {
    const Size size = reference.size();
    Image<float> map(size);
    const int bands = (size.height + band_rows - 1) / band_rows;
    workers.for_each(bands, [&](int i, int) {
        const int y0 = i * band_rows, y1 = std::min(y0 + band_rows, size.height);
        const flip::Band a(kernels, reference, y0, y1), b(kernels, image, y0, y1);
        for (int y = y0; y < y1; ++y) {
            const FilteredRow p = a.row(y), q = b.row(y);
            for (int x = 0; x < size.width; ++x) {
                const auto at = static_cast<std::size_t>(x);
                // A difference is worse where edges differ, too.
                map(x, y) =
                    std::pow(colour_error(p.colour[at], q.colour[at]), 1 - feature_error(p, q, at));
            }
        }
    });
    return map;
}

/// Applies a function to every pixel.
template <class Change>
void change_all(Image<Rgb>& image, const Workers& workers, Change change) {
    workers.for_each(image.height(), [&](int y, int) {
        for (int x = 0; x < image.width(); ++x) image(x, y) = change(image(x, y));
    });
}

/// Narkowicz 2016's fit of ACES, with the 0.6 that undoes its own exposure. In double, so that no
/// float of light overflows. Negative light goes through the same fraction, as it does with the
/// authors: its denominator has no root.
struct ToneMapper {
    static constexpr double a = 0.6 * 0.6 * 2.51, b = 0.6 * 0.03;
    static constexpr double c = 0.6 * 0.6 * 2.43, d = 0.6 * 0.59, e = 0.14;

    static float shown(double x) {
        return static_cast<float>(
            std::clamp((a * x * x + b * x) / (c * x * x + d * x + e), 0.0, 1.0));
    }
    /// The light that is shown as `value`: the positive root of its quadratic.
    static float light_of(double value) {
        const double square = a - value * c, half = 0.5 * (b - value * d) / square;
        return static_cast<float>(-half + std::sqrt(half * half + value * e / square));
    }
};

/// Sets start, stop and their number: the brightest pixel, and then the median, is shown as 0.85
/// (Andersson et al. 2021, section 4). In float, as the authors do: a whole number of stops between
/// the two must not become one exposure more.
void choose_exposures(const Image<Rgb>& reference, HdrFlipResult& result) {
    constexpr float darkest = std::numeric_limits<float>::epsilon();  // for a mostly black picture
    std::vector<float> luminances;
    for (const Rgb& c : reference.pixels()) {
        luminances.push_back(0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b);
    }
    const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
    const float brightest = *std::max_element(luminances.begin(), luminances.end());
    std::nth_element(luminances.begin(), middle, luminances.end());
    const float light = ToneMapper::light_of(0.85);
    result.start = std::log2(light / std::max(brightest, darkest));
    result.stop = std::log2(light / std::max(*middle, darkest));
    result.exposures = static_cast<int>(std::max(2.0f, std::ceil(result.stop - result.start)));
}

Image<Rgb> tone_mapped(const Image<Rgb>& light, float exposure, const Workers& workers) {
    const double factor = std::exp2(static_cast<double>(exposure));
    const auto shown = [=](float channel) {
        return ToneMapper::shown(static_cast<double>(channel) * factor);
    };
    Image<Rgb> image = light;
    change_all(image, workers,
               [&](const Rgb& c) { return Rgb(shown(c.r), shown(c.g), shown(c.b)); });
    return image;
}

}  // namespace

FlipResult flip_ldr(ImageView<const Rgb> reference, ImageView<const Rgb> image,
                    const Workers& workers, double pixels_per_degree) {
    FinitePair pair = finite_pair(reference, image);
    for (Image<Rgb>* side : {&pair.reference, &pair.image}) {
        change_all(*side, workers, [](const Rgb& encoded) {
            return srgb_decoded(glm::clamp(encoded, Rgb(0), Rgb(1)));
        });
    }
    FlipResult result;
    result.map = error_map(pair.reference.view(), pair.image.view(),
                           flip::Kernels(pixels_per_degree), workers);
    result.mean = mean_of_kept(pair, result.map);
    return result;
}

HdrFlipResult flip_hdr(ImageView<const Rgb> reference, ImageView<const Rgb> image,
                       const Workers& workers, double pixels_per_degree) {
    const FinitePair pair = finite_pair(reference, image);
    HdrFlipResult result;
    Image<float>& map = result.flip.map;
    map = Image<float>(image.size());
    result.exposure = Image<float>(image.size());
    if (image.size().area() > 0) choose_exposures(pair.reference, result);
    const flip::Kernels kernels(pixels_per_degree);
    for (int i = 0; i < result.exposures; ++i) {
        const float step = (result.stop - result.start) / static_cast<float>(result.exposures - 1);
        const float exposure = result.start + static_cast<float>(i) * step;
        const Image<float> errors =
            error_map(tone_mapped(pair.reference, exposure, workers).view(),
                      tone_mapped(pair.image, exposure, workers).view(), kernels, workers);
        for (std::size_t p = 0; p < map.pixels().size(); ++p) {
            if (i > 0 && errors.pixels()[p] <= map.pixels()[p]) continue;
            map.pixels()[p] = errors.pixels()[p];
            result.exposure.pixels()[p] = exposure;
        }
    }
    result.flip.mean = mean_of_kept(pair, map);
    return result;
}

}  // namespace luch
