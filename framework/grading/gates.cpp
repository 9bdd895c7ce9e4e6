#include "framework/grading/gates.h"

#include "framework/math/rng.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luch::grading {
namespace {

using Ids = ImageView<const std::uint32_t>;

constexpr std::uint32_t none = ~std::uint32_t{0};
constexpr double most_wrong_ids = 0.0005;
constexpr double percentile = 0.99, most_at_percentile = 1e-4, most_off_edge = 1e-3;

/// Within 1 px of an edge: not all of the nine pixels around have one id.
bool near_edge(Ids ids, int x, int y) {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, ids.height() - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, ids.width() - 1); ++u) {
            if (ids(u, v) != ids(x, y)) return true;
        }
    }
    return false;
}

/// An element's part of a signature.
std::uint32_t mark_of(std::uint32_t element, std::uint64_t how) {
    return static_cast<std::uint32_t>(Key(element).bits(how));
}

/// Which way a number is wrong and, to a power of two, by how much.
std::uint64_t how_wrong(double difference) {
    if (!std::isfinite(difference)) return 1;
    const int power = static_cast<int>(std::lround(std::log2(std::abs(difference)))) + 2048;
    return static_cast<std::uint64_t>(2 * power + (difference < 0 ? 1 : 0));
}

std::string id_text(std::uint32_t id) {
    return id == none ? "none" : std::to_string(id);
}

std::uint32_t index_of(Size size, int x, int y) {
    return static_cast<std::uint32_t>(y * size.width + x);
}

/// White where something is wrong.
Image<Rgb> marked(Size size, const std::vector<std::uint32_t>& wrong) {
    Image<Rgb> image(size, Rgb(0));
    for (const std::uint32_t index : wrong) image.pixels()[index] = Rgb(1);
    return image;
}

void point_at(Finding& finding, int x, int y, const std::string& expected, const std::string& got) {
    finding.first = fmt::format("({},{}) expected {}, got {}", x, y, expected, got);
    finding.pixel = fmt::format("{},{}", x, y);
}

}  // namespace

Finding same_ids(Ids yours, Ids reference, std::string_view thing) {
    Finding finding;
    const Size size = reference.size();
    bool all_near = true;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (yours(x, y) == reference(x, y)) continue;
            if (finding.wrong.empty()) {
                point_at(finding, x, y, id_text(reference(x, y)), id_text(yours(x, y)));
            }
            finding.wrong.push_back(index_of(size, x, y));
            finding.signature.push_back(mark_of(finding.wrong.back(), yours(x, y)));
            all_near = all_near && near_edge(reference, x, y);
        }
    }
    const std::size_t count = finding.wrong.size();
    const double allowed = most_wrong_ids * static_cast<double>(size.area());
    finding.passed = all_near && static_cast<double>(count) <= allowed;
    if (finding.passed) return {};
    finding.what = fmt::format("{} of {} pixels {} the wrong {}{}", count, size.area(),
                               count == 1 ? "has" : "have", thing,
                               all_near ? ", all within 1 px of an edge" : "");
    finding.pictures = {{"yours", id_colours(yours)},
                        {"reference", id_colours(reference)},
                        {"difference", marked(size, finding.wrong)}};
    return finding;
}

Finding same_depths(ImageView<const float> yours, ImageView<const float> reference, Ids your_ids,
                    Ids reference_ids) {
    Finding finding;
    const Size size = reference.size();
    std::vector<double> errors;
    double largest = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double got = yours(x, y), expected = reference(x, y);
            if (your_ids(x, y) != reference_ids(x, y) || !std::isfinite(expected)) continue;
            const double error = std::isfinite(got) && got > 0
                                     ? std::abs(got - expected) / std::abs(expected)
                                     : std::numeric_limits<double>::infinity();
            errors.push_back(error);
            if (!near_edge(reference_ids, x, y)) largest = std::max(largest, error);
            if (error <= most_at_percentile) continue;
            if (finding.wrong.empty()) {
                point_at(finding, x, y, fmt::format("{:.5g}", expected),
                         fmt::format("{:.5g}", got));
            }
            finding.wrong.push_back(index_of(size, x, y));
            finding.signature.push_back(mark_of(finding.wrong.back(), how_wrong(got - expected)));
        }
    }
    if (errors.empty()) return {};
    const auto rank =
        static_cast<std::ptrdiff_t>(percentile * static_cast<double>(errors.size() - 1));
    std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
    const double at_percentile = errors[static_cast<std::size_t>(rank)];
    finding.passed = at_percentile <= most_at_percentile && largest <= most_off_edge;
    if (finding.passed) return {};
    finding.what = fmt::format(
        "{} of {} pixels have the wrong depth; off the edges the largest "
        "error is {:.2g} of it",
        finding.wrong.size(), errors.size(), largest);
    finding.pictures = {{"yours", depth_greys(yours)},
                        {"reference", depth_greys(reference)},
                        {"difference", marked(size, finding.wrong)}};
    return finding;
}

Finding same_numbers(std::span<const double> yours, std::span<const double> reference,
                     double tolerance, std::string_view name, std::size_t per) {
    if (yours.size() != reference.size()) {
        return failure(
            fmt::format("{} numbers ({}) instead of {}", yours.size(), name, reference.size()));
    }
    Finding finding;
    for (std::size_t i = 0; i < yours.size(); ++i) {
        const double bound = tolerance * std::max(1.0, std::abs(reference[i]));
        if (yours[i] == reference[i] || std::abs(yours[i] - reference[i]) <= bound) continue;
        const auto element = static_cast<std::uint32_t>(i / per);
        if (finding.wrong.empty()) {
            finding.first = fmt::format("{} {} expected {:.8g}, got {:.8g}", name, element,
                                        reference[i], yours[i]);
        }
        if (finding.wrong.empty() || finding.wrong.back() != element) {
            finding.wrong.push_back(element);
        }
        finding.signature.push_back(
            mark_of(static_cast<std::uint32_t>(i), how_wrong(yours[i] - reference[i])));
    }
    finding.passed = finding.wrong.empty();
    if (finding.passed) return {};
    finding.what =
        fmt::format("{} of {}: {} is wrong", finding.wrong.size(), yours.size() / per, name);
    return finding;
}

Finding first_failure_of(std::vector<Finding> findings) {
    for (Finding& finding : findings) {
        if (!finding.passed) return std::move(finding);
    }
    return {};
}

Image<Rgb> id_colours(Ids ids) {
    Image<Rgb> image(ids.size(), Rgb(0));
    for (std::size_t i = 0; i < ids.size().area(); ++i) {
        const std::uint32_t id = ids.data()[i];
        if (id == none) continue;
        const Key key(id);
        image.pixels()[i] = 0.1f + 0.9f * Rgb(key.uniform(0), key.uniform(1), key.uniform(2));
    }
    return image;
}

Image<Rgb> depth_greys(ImageView<const float> depths) {
    float nearest = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < depths.size().area(); ++i) {
        if (depths.data()[i] > 0) nearest = std::min(nearest, depths.data()[i]);
    }
    Image<Rgb> image(depths.size(), Rgb(0));
    for (std::size_t i = 0; i < depths.size().area(); ++i) {
        const float depth = depths.data()[i];
        if (depth > 0 && std::isfinite(depth)) image.pixels()[i] = Rgb(nearest / depth);
    }
    return image;
}

}  // namespace luch::grading
