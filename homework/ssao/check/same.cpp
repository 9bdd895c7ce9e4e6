#include "homework/ssao/check/same.h"

#include "framework/grading/gates.h"

#include <fmt/format.h>

#include <cmath>

namespace luch::homework::ssao {
namespace {

using grading::Finding;

constexpr double tolerance = 1e-4;
/// Stand for what is not a number, which compares unequal even to itself, and for infinity.
constexpr double no_number = -1e300, infinity = 1e300;

double comparable(float value) {
    if (std::isnan(value)) return no_number;
    return std::isinf(value) ? std::copysign(infinity, value) : value;
}

/// Signed numbers around grey.
Image<Rgb> shown(const Image<Vec3>& plane) {
    Image<Rgb> image(plane.size());
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        image.pixels()[i] = glm::clamp(0.5f + 0.5f * plane.pixels()[i], 0.0f, 1.0f);
    }
    return image;
}

Image<Rgb> shown(const Image<float>& plane) {
    Image<Rgb> image(plane.size());
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        image.pixels()[i] = Rgb(std::clamp(plane.pixels()[i], 0.0f, 1.0f));
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

std::vector<double> numbers_of(const Image<Vec3>& plane) {
    std::vector<double> numbers;
    for (const Vec3& pixel : plane.pixels()) {
        for (int k = 0; k < 3; ++k) numbers.push_back(comparable(pixel[k]));
    }
    return numbers;
}

std::vector<double> numbers_of(const Image<float>& plane) {
    std::vector<double> numbers;
    for (const float value : plane.pixels()) numbers.push_back(comparable(value));
    return numbers;
}

}  // namespace

Finding same_plane(const Image<float>& yours, const Image<float>& reference,
                   std::string_view name) {
    return with_pictures(
        grading::same_numbers(numbers_of(yours), numbers_of(reference), tolerance, name), yours,
        reference);
}

Finding same_vectors(const Image<Vec3>& yours, const Image<Vec3>& reference,
                     std::string_view name) {
    return with_pictures(
        grading::same_numbers(numbers_of(yours), numbers_of(reference), tolerance, name, 3), yours,
        reference);
}

Finding unless_marked(const Image<std::uint8_t>& wrong, std::string_view what,
                      const Image<float>& yours, const Image<float>& reference) {
    Finding finding;
    for (std::uint32_t i = 0; i < wrong.pixels().size(); ++i) {
        if (wrong.pixels()[i] == 0) continue;
        if (finding.passed) {
            finding.first = fmt::format("expected {:.4g}, got {:.4g}", reference.pixels()[i],
                                        yours.pixels()[i]);
        }
        finding.passed = false;
        finding.wrong.push_back(i);
        // Brighter and darker mistakes are told apart.
        finding.signature.push_back(2 * i + (yours.pixels()[i] > reference.pixels()[i] ? 1 : 0));
    }
    finding.what =
        fmt::format("{} of {} pixels: {}", finding.wrong.size(), wrong.pixels().size(), what);
    return with_pictures(std::move(finding), yours, reference);
}

}  // namespace luch::homework::ssao
