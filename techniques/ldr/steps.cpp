// The lecture's steps, but for the loops without tables (spans.cpp) and what one word can do
// (word.h).
#include "framework/accel/isa.h"
#include "techniques/ldr/spans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace luch::techniques::ldr {
namespace {

const Spans& spans() {
#if defined(LUCH_X86_64_LEVELS)
    static const Isa isa = usable_isas().back();
    if (isa == Isa::v2) return spans_v2();
    if (isa == Isa::v3) return spans_v3();
    if (isa == Isa::v4) return spans_v4();
#endif
    return spans_plain();
}

/// A channel after exposure, in 0…1; what does not fit is counted.
float fitted(float channel, Misfits& misfits) {
    misfits.not_a_number += std::isnan(channel) ? 1 : 0;
    misfits.too_bright += channel > 1 ? 1 : 0;
    return channel > 0 ? std::min(channel, 1.0f) : 0.0f;
}

/// Exposure comes before the clamp: a light of 4 at ¼ is white, not a quarter of it.
void encode(std::span<const Rgb> light, float exposure, std::span<Word> words, Misfits& misfits) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto level = [&](float channel) {
            return static_cast<std::uint32_t>(fitted(channel * exposure, misfits) * 255.0f + 0.5f);
        };
        words[i] = {255, level(light[i].r), level(light[i].g), level(light[i].b)};
    }
}

void add(std::span<Word> a, std::span<const Word> b) {
    spans().add(a.data(), b.data(), a.size());
}
void modulate(std::span<Word> a, std::span<const Word> b) {
    spans().modulate(a.data(), b.data(), a.size());
}
void mix(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t> up) {
    spans().mix(a.data(), b.data(), up.data(), a.size());
}
void lerp(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t> alpha) {
    spans().lerp(a.data(), b.data(), alpha.data(), a.size());
}
void accumulate(std::span<const Word> words, std::span<Wide> sums) {
    spans().accumulate(words.data(), sums.data(), words.size());
}
/// What the screen makes of each level: linear light, 0…65535.
const std::array<std::uint32_t, 256>& linear_table() {
    static const std::array<std::uint32_t, 256> table = [] {
        std::array<std::uint32_t, 256> made{};
        for (std::size_t i = 0; i < made.size(); ++i) {
            const float linear = srgb_decoded(static_cast<float>(i) / 255);
            made[i] = static_cast<std::uint32_t>(linear * 65'535 + 0.5f);
        }
        return made;
    }();
    return table;
}

void tint(std::span<Wide> sums, std::span<const Word> albedo) {
    spans().tint(sums.data(), albedo.data(), linear_table().data(), sums.size());
}

/// 256 · 255 · sRGB(i/65535), rounded down: a level of the screen, and where between two.
const std::vector<std::uint16_t>& display_table() {
    static const std::vector<std::uint16_t> table = [] {
        std::vector<std::uint16_t> made(65'536);
        for (std::size_t i = 0; i < made.size(); ++i) {
            const double x = static_cast<double>(i) / 65'535;
            const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
            // White is a level, whatever the power's last bit.
            made[i] = static_cast<std::uint16_t>(std::min(256 * 255 * y + 1e-6, 65'280.0));
        }
        return made;
    }();
    return table;
}

std::uint32_t displayed(std::uint32_t linear_16_bits, std::uint8_t dither) {
    return (display_table()[linear_16_bits] + dither) >> 8;
}

void resolve(std::span<const Wide> sums, int n, std::span<const std::uint8_t> dither,
             std::span<Word> words) {
    const double one = static_cast<double>(n) * Wide::white;
    for (std::size_t i = 0; i < words.size(); ++i) {
        // 16 bits a channel: 257 times a word's level, which is what a single word comes back as.
        const auto mean = [&](int c) {
            const double part = sums[i].channel[c] * (65'535 / one) + 0.5;
            return static_cast<std::uint32_t>(std::min(part, 65'535.0));
        };
        words[i] = {(mean(3) + 128) / 257, displayed(mean(2), dither[i]),
                    displayed(mean(1), dither[i]), displayed(mean(0), dither[i])};
    }
}

void gather(std::span<const Rgb> light, float exposure, std::span<Wide> sums, Misfits& misfits) {
    constexpr float most = 4'294'967'040.0f;  // the largest float that fits
    const auto units = [&](float channel) {
        fitted(channel, misfits);
        return static_cast<std::uint32_t>(
            channel > 0 ? std::min(channel * static_cast<float>(Wide::white), most) : 0.0f);
    };
    for (std::size_t i = 0; i < sums.size(); ++i) {
        std::uint32_t* to = sums[i].channel;
        to[0] = plus(to[0], units(light[i].b * exposure));
        to[1] = plus(to[1], units(light[i].g * exposure));
        to[2] = plus(to[2], units(light[i].r * exposure));
    }
}

}  // namespace

Word shown(Word linear, std::uint8_t dither) {
    const auto channel = [&](int c) { return displayed(linear.channel(c) * 257, dither); };
    return {linear.alpha(), channel(2), channel(1), channel(0)};
}

Rgb seen(Word displayed) {
    static const std::array<float, 256> levels = [] {
        std::array<float, 256> made{};
        for (std::size_t i = 0; i < made.size(); ++i) {
            made[i] = srgb_decoded(static_cast<float>(i) / 255);
        }
        return made;
    }();
    return {levels[displayed.channel(2)], levels[displayed.channel(1)],
            levels[displayed.channel(0)]};
}

Steps reference() {
    return {encode, add, modulate, mix, lerp, accumulate, resolve, gather, tint};
}

}  // namespace luch::techniques::ldr
