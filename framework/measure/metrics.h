#pragma once

#include "framework/image/image.h"
#include "framework/image/io.h"
#include "framework/math/colour.h"
#include "framework/technique/outcome.h"
#include "framework/technique/technique.h"

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
/// (PSNR: infinite, SSIM: 1) for equal images, and NaN when no pixel is finite in both.
struct Errors {
    double rmse = 0;                                        ///< √ mean (v − r)²
    double relmse = 0;                                      ///< mean (v − r)² / (r + 0.01)²
    double psnr = std::numeric_limits<double>::infinity();  ///< dB, 20·log10(1/RMSE): peak 1
    double ssim = 1;       ///< mean structural similarity, as ssim() has it: peak 1
    double flip = 0;       ///< mean FLIP: flip_ldr() of sRGB numbers, flip_hdr() of linear light
    double mae = 0;        ///< mean |v − r|
    double max_error = 0;  ///< the largest |v − r| of a channel
    double p999 = 0;       ///< 99.9 % of pixels are off by no more, in their worst channel
    /// The part of pixels that are black in one image and white in the other; NaN when a pixel of
    /// either is anything else.
    double misclassified = std::numeric_limits<double>::quiet_NaN();
    double foveal_rmse = std::numeric_limits<double>::quiet_NaN();  ///< NaN without a gaze
    Encoding encoding = Encoding::srgb;                             ///< of the numbers compared
    PixelPlace max_at;  ///< the first pixel with the largest error; none where all are equal
    std::uint64_t differing = 0;  ///< pixels with any difference at all
    NonFinite non_finite;  ///< pixels with a NaN or infinity in either image; in no number above
};

/// What errors_between() cannot see in the pixels.
struct Comparison {
    Encoding encoding = Encoding::srgb;       ///< of both images
    std::optional<Gaze> gaze = std::nullopt;  ///< asks for the foveal error
};

/// Throws Error when the sizes differ or there are no pixels.
Errors errors_between(ImageView<const Rgb> reference, ImageView<const Rgb> image,
                      const Comparison& comparison = {});

/// A number of Errors that tables, reports and limits may name. Another metric is one more row.
struct Metric {
    std::string_view name;     ///< as in --fail-above and in JSON
    std::string_view label;    ///< as in tables
    std::string_view meaning;  ///< one short phrase
    double Errors::*value;
    std::string_view format = "{:.3g}";  ///< of fmt, with its unit
    bool higher_is_better = false;
    std::string_view needs = "";  ///< without which it is NaN, for an error: "two pictures of …"
};

/// What every comparison has.
std::span<const Metric> metrics();

/// What a comparison has only when it can: NaN, and best left out, elsewhere.
std::span<const Metric> special_metrics();

/// The metric of that name, special ones too. Throws Error that lists the nearest names.
const Metric& find_metric(std::string_view name);

/// The value as tables show it: "0.00123", "41.20 dB", "0.99731", "∞".
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
