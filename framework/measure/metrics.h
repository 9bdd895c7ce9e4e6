#pragma once

#include "framework/image/image.h"
#include "framework/image/io.h"
#include "framework/math/colour.h"
#include "framework/technique/outcome.h"

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace luch {

/// A pixel's position; −1 where there is none.
struct PixelPlace {
    int x = -1, y = -1;
};

/// How far an image is from its reference, over every channel of every finite pixel. All are 0
/// (PSNR: infinite) for equal images, and NaN when no pixel is finite in both.
struct Errors {
    double rmse = 0;    ///< √ mean (v − r)²
    double relmse = 0;  ///< mean (v − r)² / (max(r, 0) + 0.01)²
    double psnr = std::numeric_limits<double>::infinity();  ///< dB, 20·log10(1/RMSE): peak 1
    double max_error = 0;                                   ///< the largest |v − r| of a channel
    double p999 = 0;    ///< 99.9 % of pixels are off by no more, in their worst channel
    PixelPlace max_at;  ///< the first pixel with the largest error; none where all are equal
    std::uint64_t differing = 0;  ///< pixels with any difference at all
    NonFinite non_finite;  ///< pixels with a NaN or infinity in either image; in no number above
};

/// Throws Error when the sizes differ or there are no pixels.
Errors errors_between(ImageView<const Rgb> reference, ImageView<const Rgb> image);

/// A number of Errors that tables, reports and limits may name. Another metric is one more row.
struct Metric {
    std::string_view name;     ///< as in --fail-above and in JSON
    std::string_view label;    ///< as in tables
    std::string_view meaning;  ///< one short phrase
    double Errors::*value;
    bool higher_is_better = false;
};
std::span<const Metric> metrics();

/// The metric of that name. Throws Error that lists the nearest names.
const Metric& find_metric(std::string_view name);

/// The value as tables show it: "0.00123", "41.20 dB", "∞".
std::string shown(const Metric& metric, const Errors& errors);

/// As displayed: the sRGB curve, clamped to 0..1. A pixel that is not finite becomes NaN in every
/// channel, so that encoding hides none.
Image<Rgb> displayed(ImageView<const Rgb> linear);

/// Two pictures brought into one encoding.
struct ComparablePair {
    Image<Rgb> reference, image;
    Encoding encoding = Encoding::srgb;
    std::string why;  ///< "as displayed (sRGB, clamped to 0..1): …"
};

/// As wanted; without a wish linear when both are linear, else as displayed.
ComparablePair comparable(const Picture& reference, const Picture& image,
                          std::optional<Encoding> wanted = {});

}  // namespace luch
