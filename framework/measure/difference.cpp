#include "framework/measure/difference.h"

#include "framework/base/text.h"
#include "framework/image/io.h"
#include "framework/measure/paired.h"

#include <array>
#include <cmath>

namespace luch {
namespace {

constexpr double steps_of_byte = 255;
constexpr double doublings = 9;  // from half a step to 256 steps of a byte
const Rgb not_finite(1, 0, 1);

// Brightness rises evenly along the ramp, so that it also reads in grey.
const std::array<Rgb, 6> ramp{Rgb(0.05f, 0.08f, 0.30f), Rgb(0.28f, 0.12f, 0.55f),
                              Rgb(0.67f, 0.18f, 0.45f), Rgb(0.94f, 0.42f, 0.20f),
                              Rgb(0.99f, 0.78f, 0.25f), Rgb(1.00f, 1.00f, 0.95f)};

/// Calls colour_of(|a − b|) for every pixel.
template <class ColourOf>
Image<Rgb> mapped(ImageView<const Rgb> a, ImageView<const Rgb> b, ColourOf colour_of) {
    check_sizes(a.size(), b.size());
    Image<Rgb> image(a.size());
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const Rgb off = glm::abs(a.data()[i] - b.data()[i]);
        image.pixels()[i] = all_finite(off) ? colour_of(off) : not_finite;
    }
    return image;
}

}  // namespace

Image<Rgb> amplified_difference(ImageView<const Rgb> a, ImageView<const Rgb> b, double factor) {
    return mapped(a, b, [&](const Rgb& off) {
        return glm::clamp(off * static_cast<float>(factor), Rgb(0), Rgb(1));
    });
}

Image<Rgb> error_map(ImageView<const Rgb> a, ImageView<const Rgb> b) {
    return mapped(a, b,
                  [](const Rgb& off) { return error_colour(static_cast<double>(max_norm(off))); });
}

Rgb error_colour(double error) {
    if (std::isnan(error)) return not_finite;
    if (error <= 0) return Rgb(0);
    return legend_colour((std::log2(error * steps_of_byte) + 1) / doublings);
}

Rgb legend_colour(double position) {
    const double along = std::clamp(position, 0.0, 1.0) * static_cast<double>(ramp.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(along), ramp.size() - 2);
    return glm::mix(ramp[below], ramp[below + 1],
                    static_cast<float>(along - static_cast<double>(below)));
}

std::vector<LegendTick> error_legend() {
    std::vector<LegendTick> ticks;
    for (const int steps : {1, 4, 16, 64, 255}) {
        ticks.push_back({(std::log2(steps) + 1) / doublings, std::to_string(steps)});
    }
    return ticks;
}

void write_displayed(const std::filesystem::path& file, ImageView<const Rgb> displayed) {
    const std::string ending = lower(file.extension().string());
    if (ending == ".exr" || ending == ".hdr") return write_picture(file, displayed);
    Image<Rgb> linear(displayed.size());
    for (std::size_t i = 0; i < linear.pixels().size(); ++i) {
        linear.pixels()[i] = srgb_decoded(displayed.data()[i]);
    }
    write_picture(file, linear.view());
}

}  // namespace luch
