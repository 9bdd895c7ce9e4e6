// The students' kit: no reference steps, but something in their place while they are not written,
// so that the others can be seen at work: every channel black or white, the brighter of two, and
// the like. And what is given: gather, tint, and how words are shown.
#include "framework/math/colour.h"
#include "techniques/ldr/ldr.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luch::techniques::ldr {
namespace {

void encode(std::span<const Rgb> light, float exposure, std::span<Word> words, Misfits&) {
    const auto bright = [&](float channel) { return channel * exposure > 0.5f ? 255u : 0u; };
    std::ranges::transform(light, words.begin(), [&](const Rgb& each) {
        return Word(255, bright(each.r), bright(each.g), bright(each.b));
    });
}

void add(std::span<Word> a, std::span<const Word> b) {
    std::ranges::transform(a, b, a.begin(), [](Word x, Word y) { return Word(x.bits | y.bits); });
}

void modulate(std::span<Word> a, std::span<const Word> b) {
    std::ranges::transform(a, b, a.begin(), [](Word x, Word y) { return Word(x.bits & y.bits); });
}

void mix(std::span<Word>, std::span<const Word>, std::span<const std::uint8_t>) {}

void lerp(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t> alpha) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = alpha[i] < 128 ? a[i] : b[i];
}

void accumulate(std::span<const Word> words, std::span<Wide> sums) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
        for (int c = 0; c < 4; ++c) sums[i].channel[c] = words[i].channel(c) * Wide::level;
    }
}

void resolve(std::span<const Wide> sums, int, std::span<const std::uint8_t>,
             std::span<Word> words) {
    std::ranges::transform(sums, words.begin(), [](const Wide& sum) {
        const auto bright = [&](int c) { return sum.channel[c] > Wide::white / 2 ? 255u : 0u; };
        return Word(bright(3), bright(2), bright(1), bright(0));
    });
}

/// Misfits are not counted: that is asked for.
void gather(std::span<const Rgb> light, float exposure, std::span<Wide> sums, Misfits&) {
    constexpr float largest = 0xffffff00p0f;  // that fits
    for (std::size_t i = 0; i < sums.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const float units = light[i][2 - c] * exposure * static_cast<float>(Wide::white);
            // What is no number is not greater, either.
            if (!(units > 0)) continue;
            std::uint32_t& sum = sums[i].channel[c];
            sum = plus(sum, static_cast<std::uint32_t>(std::min(units, largest)));
        }
    }
}

/// What the screen makes of each level.
const std::array<float, 256>& linear_levels() {
    static const std::array<float, 256> all = [] {
        std::array<float, 256> made{};
        float level = 0;
        for (float& linear : made) linear = srgb_decoded(level++ / 255);
        return made;
    }();
    return all;
}

/// In 65,535 parts.
std::uint64_t parts_of(std::uint32_t level) {
    return static_cast<std::uint64_t>(linear_levels()[level] * 65'535 + 0.5f);
}

void tint(std::span<Wide> sums, std::span<const Word> albedo) {
    std::array<std::uint64_t, 256> parts{};
    for (std::uint32_t i = 0; i < 256; ++i) parts[i] = parts_of(i);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const std::uint64_t product = sums[i].channel[c] * parts[albedo[i].channel(c)];
            sums[i].channel[c] = static_cast<std::uint32_t>((product + 32'767) / 65'535);
        }
    }
}

/// A level of the screen, and how many parts in 256 of the way to the next.
std::uint32_t curve(std::uint32_t level) {
    const double encoded = srgb_encoded(static_cast<float>(level) / 255);
    return static_cast<std::uint32_t>(std::min(256 * 255 * encoded, 256 * 255.0));
}

}  // namespace

Word shown(Word linear, std::uint8_t dither) {
    static const std::array<std::uint32_t, 256> curved = [] {
        std::array<std::uint32_t, 256> made{};
        for (std::uint32_t i = 0; i < 256; ++i) made[i] = curve(i);
        return made;
    }();
    const auto level = [&](int c) { return (curved[linear.channel(c)] + dither) / 256; };
    return {linear.alpha(), level(2), level(1), level(0)};
}

Rgb seen(Word displayed) {
    Rgb colour;
    for (int c = 0; c < 3; ++c) colour[c] = linear_levels()[displayed.channel(2 - c)];
    return colour;
}

Steps reference() {
    return {encode, add, modulate, mix, lerp, accumulate, resolve, gather, tint};
}

}  // namespace luch::techniques::ldr
