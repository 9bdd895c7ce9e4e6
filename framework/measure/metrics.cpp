#include "framework/measure/metrics.h"

#include "framework/base/error.h"
#include "framework/base/text.h"
#include "framework/measure/flip.h"
#include "framework/measure/foveal.h"
#include "framework/measure/paired.h"
#include "framework/measure/ssim.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace luch {
namespace {

constexpr std::array all_metrics{
    Metric{"rmse", "RMSE", "root of the mean squared error", &Errors::rmse},
    Metric{"relmse", "relMSE", "mean squared error relative to the reference", &Errors::relmse},
    Metric{"psnr", "PSNR", "peak signal-to-noise ratio, peak 1", &Errors::psnr, "{:.2f} dB", true},
    Metric{"ssim", "SSIM", "structural similarity, 1 for equal", &Errors::ssim, "{:.5f}", true},
    Metric{"flip", "FLIP", "what an eye sees when flipping between the two, 0..1", &Errors::flip},
    Metric{"mae", "MAE", "mean absolute error", &Errors::mae},
    Metric{"max", "max |e|", "largest error of a channel", &Errors::max_error},
    Metric{"p999", "p99.9", "99.9 % of pixels are off by no more", &Errors::p999},
    Metric{"misclassified", "wrong", "part of pixels on the wrong side of black and white",
           &Errors::misclassified, "{:.3g}", false, "pictures of black and white pixels only"},
    Metric{"foveal_rmse", "foveal", "RMSE weighted by the acuity around the gaze",
           &Errors::foveal_rmse, "{:.3g}", false, "a gaze (--gaze X,Y)"},
};
constexpr std::size_t special_count = 2;

bool is_binary(const Rgb& colour) {
    return colour == Rgb(0) || colour == Rgb(1);
}

/// Sums over pixels, in reading order, so that the result does not depend on threads.
struct Sums {
    double squared = 0;
    double relative = 0;
    double absolute = 0;
    bool binary = true;  ///< so far every pixel is black or white
    std::uint64_t swapped = 0;
    std::vector<double> worst_channel;  ///< one for each finite pixel

    void add(const Rgb& reference, const Rgb& value, PixelPlace place, Errors& errors) {
        double worst = 0;
        for (int c = 0; c < 3; ++c) {
            const double off = static_cast<double>(value[c]) - static_cast<double>(reference[c]);
            const double scale = static_cast<double>(reference[c]) + 0.01;
            squared += off * off;
            absolute += std::abs(off);
            if (off != 0) relative += off * off / (scale * scale);
            worst = std::max(worst, std::abs(off));
        }
        worst_channel.push_back(worst);
        binary = binary && is_binary(reference) && is_binary(value);
        if (binary && reference != value) ++swapped;
        if (worst > 0) ++errors.differing;
        if (worst > errors.max_error) {
            errors.max_error = worst;
            errors.max_at = place;
        }
    }
};

/// The nearest rank: the smallest value that at least 99.9 % of all values do not exceed.
double percentile_999(std::vector<double>& values) {
    const std::size_t rank = (values.size() * 999 + 999) / 1000;
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

void finish(Sums& sums, Errors& errors) {
    if (sums.worst_channel.empty()) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        for (const Metric& metric : all_metrics) errors.*metric.value = nan;
        return;
    }
    const auto pixels = static_cast<double>(sums.worst_channel.size());
    errors.rmse = std::sqrt(sums.squared / (3 * pixels));
    errors.relmse = sums.relative / (3 * pixels);
    errors.mae = sums.absolute / (3 * pixels);
    if (errors.rmse > 0) errors.psnr = -20 * std::log10(errors.rmse);
    errors.p999 = percentile_999(sums.worst_channel);
    if (sums.binary) errors.misclassified = static_cast<double>(sums.swapped) / pixels;
}

/// The metrics that look at a pixel's neighbours.
void look_around(ImageView<const Rgb> reference, ImageView<const Rgb> image,
                 const Comparison& comparison, Errors& errors) {
    const Workers workers;
    errors.ssim = ssim(reference, image, workers).mean;
    errors.flip = comparison.encoding == Encoding::linear
                      ? flip_hdr(reference, image, workers).flip.mean
                      : flip_ldr(reference, image, workers).mean;
    if (comparison.gaze) errors.foveal_rmse = foveal_rmse(reference, image, *comparison.gaze);
}

Image<Rgb> decoded(ImageView<const Rgb> encoded) {
    Image<Rgb> linear(encoded.size());
    for (std::size_t i = 0; i < linear.pixels().size(); ++i) {
        linear.pixels()[i] = srgb_decoded(encoded.data()[i]);
    }
    return linear;
}

Image<Rgb> in_encoding(const Picture& picture, Encoding wanted) {
    if (picture.encoding == wanted) return picture.pixels;
    return wanted == Encoding::linear ? decoded(picture.pixels.view())
                                      : displayed(picture.pixels.view());
}

}  // namespace

Errors errors_between(ImageView<const Rgb> reference, ImageView<const Rgb> image,
                      const Comparison& comparison) {
    check_sizes(reference.size(), image.size());
    if (reference.size().area() == 0) throw Error("the images have no pixels to compare");
    Errors errors;
    errors.encoding = comparison.encoding;
    Sums sums;
    sums.worst_channel.reserve(image.size().area());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (all_finite(reference(x, y)) && all_finite(image(x, y))) {
                sums.add(reference(x, y), image(x, y), {x, y}, errors);
            } else if (errors.non_finite.count++ == 0) {
                errors.non_finite.first_x = x;
                errors.non_finite.first_y = y;
            }
        }
    }
    look_around(reference, image, comparison, errors);
    finish(sums, errors);
    return errors;
}

std::span<const Metric> metrics() {
    return std::span(all_metrics).first(all_metrics.size() - special_count);
}

std::span<const Metric> special_metrics() {
    return std::span(all_metrics).last(special_count);
}

const Metric& find_metric(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Metric& metric : all_metrics) {
        if (metric.name == name) return metric;
        names.push_back(metric.name);
    }
    throw Error(fmt::format("there is no metric \"{}\"; {}", name, did_you_mean(name, names)));
}

std::string shown(const Metric& metric, const Errors& errors) {
    const double value = errors.*metric.value;
    if (std::isinf(value)) return "∞";
    if (std::isnan(value)) return "NaN";
    return fmt::format(fmt::runtime(metric.format), value);
}

Image<Rgb> displayed(ImageView<const Rgb> linear) {
    Image<Rgb> encoded(linear.size(), Rgb(std::numeric_limits<float>::quiet_NaN()));
    for (std::size_t i = 0; i < encoded.pixels().size(); ++i) {
        const Rgb& colour = linear.data()[i];
        if (all_finite(colour)) encoded.pixels()[i] = srgb_encoded(colour);
    }
    return encoded;
}

ComparablePair comparable(const Picture& reference, const Picture& image,
                          std::optional<Encoding> wanted) {
    const bool mixed = reference.encoding != image.encoding;
    ComparablePair pair;
    pair.encoding = wanted.value_or(mixed ? Encoding::srgb : image.encoding);
    pair.why = pair.encoding == Encoding::linear ? "in linear light"
                                                 : "as displayed (sRGB, clamped to 0..1)";
    if (mixed) pair.why += "; one of them is linear, the other sRGB";
    pair.reference = in_encoding(reference, pair.encoding);
    pair.image = in_encoding(image, pair.encoding);
    return pair;
}

}  // namespace luch
