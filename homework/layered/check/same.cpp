#include "homework/layered/check/same.h"

#include "framework/grading/gates.h"

#include <fmt/format.h>

#include <cmath>

namespace luch::homework::layered {
namespace {

using grading::Finding;

constexpr double tolerance = 1e-4;
/// Stands for what is not a number, which compares unequal even to itself.
constexpr double no_number = -1e300;

double comparable(float value) {
    return std::isnan(value) ? no_number : value;
}

/// Premultiplied over grey, so that both coverage and colour show.
Image<Rgb> shown(const Image<Rgba>& layer) {
    constexpr float grey = 0.3f;
    Image<Rgb> image(layer.size());
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const Rgba& pixel = layer.pixels()[i];
        image.pixels()[i] = Rgb(pixel) + (1 - pixel.a) * grey;
    }
    return image;
}

Image<Rgb> shown(const Image<float>& plane) {
    float most = 0;
    for (const float value : plane.pixels()) {
        if (std::isfinite(value)) most = std::max(most, value);
    }
    Image<Rgb> image(plane.size());
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        image.pixels()[i] = Rgb(most > 0 ? plane.pixels()[i] / most : 0);
    }
    return image;
}

template <class Picture>
Finding with_pictures(Finding finding, const Picture& yours, const Picture& reference) {
    if (finding.passed) return finding;
    Image<Rgb> marked(reference.size(), Rgb(0));
    for (const std::uint32_t pixel : finding.wrong) {
        if (pixel < marked.pixels().size()) marked.pixels()[pixel] = Rgb(1);
    }
    if (!finding.wrong.empty()) {
        const int width = reference.width(), first = static_cast<int>(finding.wrong.front());
        finding.pixel = fmt::format("{},{}", first % width, first / width);
        finding.first = fmt::format("({}): {}", finding.pixel, finding.first);
    }
    finding.pictures = {
        {"yours", shown(yours)}, {"reference", shown(reference)}, {"difference", marked}};
    return finding;
}

std::vector<double> numbers_of(const Image<Rgba>& layer) {
    std::vector<double> numbers;
    for (const Rgba& pixel : layer.pixels()) {
        for (int k = 0; k < 4; ++k) numbers.push_back(comparable(pixel[k]));
    }
    return numbers;
}

std::vector<double> numbers_of(const Image<float>& plane) {
    std::vector<double> numbers;
    for (const float value : plane.pixels()) numbers.push_back(comparable(value));
    return numbers;
}

}  // namespace

Finding same_layers(const Image<Rgba>& yours, const Image<Rgba>& reference) {
    return with_pictures(grading::same_numbers(numbers_of(yours), numbers_of(reference), tolerance,
                                               "the colour or coverage of pixel", 4),
                         yours, reference);
}

Finding same_plane(const Image<float>& yours, const Image<float>& reference,
                   std::string_view name) {
    return with_pictures(
        grading::same_numbers(numbers_of(yours), numbers_of(reference), tolerance, name), yours,
        reference);
}

}  // namespace luch::homework::layered
