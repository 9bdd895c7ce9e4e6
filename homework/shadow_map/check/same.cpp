#include "homework/shadow_map/check/same.h"

#include "framework/grading/gates.h"
#include "homework/shadow_map/check/store.h"

#include <fmt/format.h>

#include <cmath>

namespace luch::homework::shadow_map {
namespace {

using grading::Finding;

constexpr double tolerance = 1e-4;
/// Stands for what is not a number, which compares unequal even to itself.
constexpr double no_number = -1e300;

std::vector<double> numbers_of(std::span<const Texel> texels) {
    std::vector<double> numbers;
    for (const auto& [face, x, y] : texels) {
        numbers.insert(numbers.end(), {double(face), double(x), double(y)});
    }
    return numbers;
}

std::vector<double> numbers_of(std::span<const float> shares) {
    std::vector<double> numbers;
    for (const float share : shares) numbers.push_back(std::isnan(share) ? no_number : share);
    return numbers;
}

std::string text_of(const Texel& texel) {
    return fmt::format("{{{}, {}, {}}}", texel.face, texel.x, texel.y);
}

/// What the camera sees: shares where one is known, else blue.
Image<Rgb> seen(std::span<const float> shares, const Sample& sample) {
    Image<Rgb> image(sample.scene->settings.frame, Rgb(0, 0.02f, 0.1f));
    for (std::size_t i = 0; i < shares.size(); ++i) {
        image.pixels()[sample.pixels[i]] = Rgb(0.02f + 0.98f * std::clamp(shares[i], 0.0f, 1.0f));
    }
    return image;
}

/// A place on the sheet of all faces, for which no viewer has a pixel.
Finding on_its_face(Finding finding, int n) {
    finding.pixel.clear();
    if (finding.passed || finding.wrong.empty()) return finding;
    const int first = static_cast<int>(finding.wrong.front()), x = first % (3 * n),
              y = first / (3 * n);
    const std::size_t numbers = finding.first.find(')');
    finding.first =
        fmt::format("face {}, texel ({},{}){}", y / n * 3 + x / n, x % n, y % n,
                    numbers == std::string::npos ? "" : finding.first.substr(numbers + 1));
    return finding;
}

/// 0: nothing, 1: a surface, 2: neither can be said.
Image<std::uint32_t> gaps_of(const Image<float>& sheet) {
    Image<std::uint32_t> gaps(sheet.size());
    for (std::size_t i = 0; i < gaps.pixels().size(); ++i) {
        const float distance = sheet.pixels()[i];
        gaps.pixels()[i] = distance == std::numeric_limits<float>::infinity() ? 0
                           : std::isfinite(distance) && distance > 0          ? 1
                                                                              : 2;
    }
    return gaps;
}

}  // namespace

const Steps& steps_in(const std::any& steps) {
    return *std::any_cast<Steps>(&steps);
}

Finding same_texels(std::span<const Texel> yours, std::span<const Texel> reference,
                    std::string_view of) {
    Finding finding =
        grading::same_numbers(numbers_of(yours), numbers_of(reference), 0, "the texel of", 3);
    if (finding.passed || finding.wrong.empty()) return finding;
    const std::size_t first = finding.wrong.front();
    finding.what = fmt::format("{} of {} {}s have the wrong texel", finding.wrong.size(),
                               reference.size(), of);
    finding.first = fmt::format("{} {} expected {}, got {} (face, x, y)", of, first,
                                text_of(reference[first]), text_of(yours[first]));
    return finding;
}

Finding same_shares(std::span<const float> yours, std::span<const float> reference,
                    std::string_view of) {
    return grading::same_numbers(numbers_of(yours), numbers_of(reference), tolerance,
                                 fmt::format("the share of {}", of));
}

Finding same_shares_seen(std::span<const float> yours, std::span<const float> reference,
                         const Sample& sample) {
    Finding finding = same_shares(yours, reference, "receiver");
    if (finding.passed || finding.wrong.empty()) return finding;
    Image<Rgb> marked(sample.scene->settings.frame, Rgb(0));
    for (const std::uint32_t i : finding.wrong) marked.pixels()[sample.pixels[i]] = Rgb(1);
    const std::size_t first = finding.wrong.front();
    const int pixel = static_cast<int>(sample.pixels[first]), width = marked.width();
    finding.pixel = fmt::format("{},{}", pixel % width, pixel / width);
    finding.what = fmt::format("{} of {} pixels have the wrong share of light",
                               finding.wrong.size(), reference.size());
    finding.first = fmt::format("({}) expected {:.4g}, got {:.4g}", finding.pixel, reference[first],
                                yours[first]);
    finding.pictures = {{"yours", seen(yours, sample)},
                        {"reference", seen(reference, sample)},
                        {"difference", marked}};
    return finding;
}

Finding same_distances(const CubeMap& yours, const CubeMap& reference, const Sample& sample) {
    const Image<float> got = sheet_of(yours), expected = sheet_of(reference);
    const Image<std::uint32_t> nodes = sheet_of(sample.nodes);
    Image<std::uint32_t> your_nodes = nodes;
    // What is not compared has another id: where one of both has nothing.
    constexpr NodeId neither = no_node - 1;
    for (std::size_t i = 0; i < got.pixels().size(); ++i) {
        const bool nothing = got.pixels()[i] == std::numeric_limits<float>::infinity();
        if (nothing || nodes.pixels()[i] == no_node) your_nodes.pixels()[i] = neither;
    }
    if (std::ranges::all_of(your_nodes.pixels(), [](NodeId node) { return node == neither; })) {
        return grading::failure("no texel has a surface");
    }
    Finding finding =
        grading::same_depths(got.view(), expected.view(), your_nodes.view(), nodes.view());
    const std::size_t depth = finding.what.find("pixels have the wrong depth");
    if (depth != std::string::npos) {
        finding.what.replace(depth, 27, "texels have the wrong distance");
    }
    return on_its_face(std::move(finding), yours.n);
}

Finding same_gaps(const CubeMap& yours, const CubeMap& reference) {
    const Image<float> got = sheet_of(yours), expected = sheet_of(reference);
    Finding finding = grading::same_ids(gaps_of(got).view(), gaps_of(expected).view());
    if (finding.passed) return finding;
    const std::size_t first = finding.wrong.front();
    finding.what = fmt::format(
        "{} texels are not infinite where nothing is, or not a length where something is",
        finding.wrong.size());
    finding.first =
        fmt::format(") expected {:.5g}, got {:.5g}", expected.pixels()[first], got.pixels()[first]);
    return on_its_face(std::move(finding), yours.n);
}

}  // namespace luch::homework::shadow_map
