#include "homework/ldr/check/same_words.h"

#include "framework/math/rng.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace luch::homework::ldr {
namespace {

using grading::Finding;

constexpr const char* channel_names[] = {"blue", "green", "red", "alpha"};

/// An element's part of a signature: which channel, and how far off.
void mark(Finding& finding, std::size_t pixel, int channel, std::int64_t off) {
    const auto element =
        static_cast<std::uint32_t>(4 * pixel) + static_cast<std::uint32_t>(channel);
    finding.wrong.push_back(element);
    finding.signature.push_back(
        static_cast<std::uint32_t>(Key(element).bits(static_cast<std::uint64_t>(off))));
}

void point_at(Finding& finding, std::size_t pixel, int channel, Size where, std::uint32_t expected,
              std::uint32_t got) {
    const auto width = static_cast<std::size_t>(std::max(where.width, 1));
    finding.pixel = fmt::format("{},{}", pixel % width, pixel / width);
    finding.first = fmt::format("({}) {}: expected {}, got {}", finding.pixel,
                                channel_names[channel], expected, got);
}

Image<Rgb> picture_of(std::span<const Word> words, Size size) {
    Image<Rgb> image(size);
    for (std::size_t i = 0; i < words.size(); ++i)
        image.pixels()[i] = techniques::ldr::seen(words[i]);
    return image;
}

void add_pictures(Finding& finding, std::span<const Word> yours, std::span<const Word> reference,
                  Size size) {
    if (size.area() != reference.size()) return;
    Image<Rgb> difference(size);
    for (std::size_t i = 0; i < reference.size(); ++i) {
        const Word a = yours[i], b = reference[i];
        for (int c = 0; c < 3; ++c) {
            const int off = static_cast<int>(a.channel(2 - c)) - static_cast<int>(b.channel(2 - c));
            difference.pixels()[i][c] = std::min(static_cast<float>(std::abs(off)) / 16, 1.0f);
        }
    }
    finding.pictures = {{"yours", picture_of(yours, size)},
                        {"reference", picture_of(reference, size)},
                        {"difference", difference}};
}

/// Counts and marks what differs.
struct Distances {
    std::size_t channels = 0, beyond_one = 0, beyond_eight = 0;
    double sum = 0;
    [[nodiscard]] double mean() const { return sum / static_cast<double>(channels); }
    [[nodiscard]] bool passed() const {
        const auto share = [&](std::size_t count) {
            return static_cast<double>(count) / static_cast<double>(channels);
        };
        return share(beyond_one) <= 0.001 && share(beyond_eight) <= 0.0005 &&
               std::abs(mean()) <= 0.1;
    }
};

Distances distances(std::span<const Word> yours, std::span<const Word> reference, Size where,
                    Finding& finding) {
    Distances all;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            const auto expected = reference[i].channel(c), got = yours[i].channel(c);
            const int off = static_cast<int>(got) - static_cast<int>(expected);
            ++all.channels;
            all.sum += off;
            all.beyond_one += std::abs(off) > 1 ? 1 : 0;
            all.beyond_eight += std::abs(off) > 8 ? 1 : 0;
            if (off == 0) continue;
            if (finding.wrong.empty()) point_at(finding, i, c, where, expected, got);
            mark(finding, i, c, off);
        }
    }
    return all;
}

}  // namespace

Finding same_words(std::span<const Word> yours, std::span<const Word> reference, Size where) {
    Finding finding;
    const Distances all = distances(yours, reference, where, finding);
    if (all.passed()) return {};
    finding.passed = false;
    finding.what = fmt::format(
        "of {} channels {} are more than one level off, {} more than eight; on the whole {:+.2f}",
        all.channels, all.beyond_one, all.beyond_eight, all.mean());
    add_pictures(finding, yours, reference, where);
    return finding;
}

Finding exactly(std::span<const Word> yours, std::span<const Word> expected,
                std::string_view what) {
    Finding finding;
    const Size line{static_cast<int>(expected.size()), 1};
    distances(yours, expected, line, finding);
    if (finding.wrong.empty()) return {};
    finding.passed = false;
    finding.pixel.clear();
    finding.what = fmt::format("{}: not so in {} channels", what, finding.wrong.size());
    return finding;
}

Finding same_sums(std::span<const Wide> yours, std::span<const Wide> reference) {
    Finding finding;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            const std::uint32_t expected = reference[i].channel[c], got = yours[i].channel[c];
            const std::int64_t off = std::int64_t{got} - std::int64_t{expected};
            if (std::abs(off) <= Wide::level / 64) continue;
            if (finding.wrong.empty()) point_at(finding, i, c, sample_size, expected, got);
            mark(finding, i, c, off);
        }
    }
    if (finding.wrong.empty()) return {};
    finding.passed = false;
    finding.what =
        fmt::format("{} of {} channels are wrong", finding.wrong.size(), 4 * reference.size());
    return finding;
}

}  // namespace luch::homework::ldr
