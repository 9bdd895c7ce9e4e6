#include "framework/measure/metrics.h"

#include "framework/base/error.h"
#include "framework/base/text.h"

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
    Metric{"psnr", "PSNR", "peak signal-to-noise ratio, peak 1", &Errors::psnr, true},
    Metric{"max", "max |e|", "largest error of a channel", &Errors::max_error},
    Metric{"p999", "p99.9", "99.9 % of pixels are off by no more", &Errors::p999},
};

/// Sums over pixels, in reading order, so that the result does not depend on threads.
struct Sums {
    double squared = 0;
    double relative = 0;
    std::vector<double> worst_channel;  ///< one for each finite pixel

    void add(const Rgb& reference, const Rgb& value, PixelPlace place, Errors& errors) {
        double worst = 0;
        for (int c = 0; c < 3; ++c) {
            const double off = static_cast<double>(value[c]) - static_cast<double>(reference[c]);
            const double scale = std::max(static_cast<double>(reference[c]), 0.0) + 0.01;
            squared += off * off;
            relative += off * off / (scale * scale);
            worst = std::max(worst, std::abs(off));
        }
        worst_channel.push_back(worst);
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
    const double channels = 3.0 * static_cast<double>(sums.worst_channel.size());
    errors.rmse = std::sqrt(sums.squared / channels);
    errors.relmse = sums.relative / channels;
    if (errors.rmse > 0) errors.psnr = -20 * std::log10(errors.rmse);
    errors.p999 = percentile_999(sums.worst_channel);
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

Errors errors_between(ImageView<const Rgb> reference, ImageView<const Rgb> image) {
    if (reference.size() != image.size()) {
        throw Error(
            fmt::format("the images differ in size, {}x{} and {}x{}: compare two of one size",
                        reference.width(), reference.height(), image.width(), image.height()));
    }
    if (reference.size().area() == 0) throw Error("the images have no pixels to compare");
    Errors errors;
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
    finish(sums, errors);
    return errors;
}

std::span<const Metric> metrics() {
    return all_metrics;
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
    return metric.higher_is_better ? fmt::format("{:.2f} dB", value) : fmt::format("{:.3g}", value);
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
