#pragma once

#include "framework/math/colour.h"
#include "framework/technique/technique.h"
#include "techniques/ldr/word.h"

#include <cstddef>
#include <memory>
#include <span>

// A frame whose colours are words of 32 bits. README.md has the idea, the formulas and where it
// fails.
namespace luch::techniques::ldr {

/// Four channels with room for sums: blue, green, red, alpha, as in a word. A channel's unit is
/// 1/4096 of a word's level, so 1 is 255 · 4096, and 4,112 times white fit in. Sums that are larger
/// stay at the largest.
struct Wide {
    static constexpr std::uint32_t level = 4096, white = 255 * level;
    std::uint32_t channel[4]{};
    bool operator==(const Wide&) const = default;
};

/// a + b, no more than the largest.
LUCH_LDR_INLINE std::uint32_t plus(std::uint32_t a, std::uint32_t b) {
    return a + b < a ? ~std::uint32_t{0} : a + b;
}

/// What did not fit into a word.
struct Misfits {
    std::uint64_t not_a_number = 0;  ///< channels, made 0
    std::uint64_t too_bright = 0;    ///< channels above 1 (after exposure), made 255
    bool operator==(const Misfits&) const = default;
};

/// The lecture's steps; a homework replaces one after the other. Spans of one call are equally
/// long; those that are written hold no part of those that are read. Words hold linear light until
/// resolve() and show() make words for the screen, in sRGB.
struct Steps {
    /// Light as words: each channel times `exposure` (> 0), then clamped to 0…1, then rounded to
    /// the nearest of 255 levels, halves up. NaN becomes 0. Both misfits are counted (added).
    /// Alpha is 255.
    void (*encode)(std::span<const Rgb> light, float exposure, std::span<Word> words,
                   Misfits& misfits);

    /// a ← a + b, at most 255 a channel.
    void (*add)(std::span<Word> a, std::span<const Word> b);

    /// a ← round(a·b/255), channel by channel, alpha too.
    void (*modulate)(std::span<Word> a, std::span<const Word> b);

    /// a ← (a + b)/2; halves are rounded down where up is 0, up where it is 1.
    void (*mix)(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t> up);

    /// a ← round(a + (b − a)·alpha/255), its alpha too.
    void (*lerp)(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t> alpha);

    /// sums ← sums + words, every level worth Wide::level.
    void (*accumulate)(std::span<const Word> words, std::span<Wide> sums);

    /// Words for the screen, from sums of n ≥ 1 words: the mean, as sRGB (alpha as it is), in 255
    /// levels. What lies d/256 above a level becomes the next where d + dither ≥ 256; a dither of
    /// 128 rounds to nearest. Means above 1 become 255.
    void (*resolve)(std::span<const Wide> sums, int n, std::span<const std::uint8_t> dither,
                    std::span<Word> words);

    // Beside those of the lecture, for what a word cannot hold.

    /// sums ← sums + light·exposure, rounded down to whole units. NaN and what is negative add
    /// nothing; misfits are counted as by encode(). Alpha stays.
    void (*gather)(std::span<const Rgb> light, float exposure, std::span<Wide> sums,
                   Misfits& misfits);

    /// sums ← sums·albedo, rounded to nearest; albedo's words are sRGB, as resolve() makes them, or
    /// the dark ones would have too few levels. Alpha stays.
    void (*tint)(std::span<Wide> sums, std::span<const Word> albedo);
};

/// The steps as the lecture has them.
Steps reference();

/// A word of linear light as resolve() shows it when it is the only one.
Word shown(Word linear, std::uint8_t dither = 128);

/// What the screen makes of a word: linear light. Alpha is left out.
Rgb seen(Word displayed);

enum class Tone { clamp, reinhard };

/// What a user may set.
struct Params {
    bool wide = true;        ///< accumulators, where the plan needs them; false: never
    bool dither = true;      ///< in resolve() and show
    int levels = 256;        ///< of a channel; other than 256: worked out, not packed
    double exposure_ev = 0;  ///< stops; light is multiplied by 2^exposure
    int tone = 0;            ///< an index: Tone
    bool textures = true;    ///< bitmaps in words, where they are as good
};

/// The technique, made of these steps; each one's holes are filled by the reference.
std::unique_ptr<Technique> make(const Steps& steps);

/// By how much it may be off from the baseline, see TechniqueInfo::resolution: where the screen's
/// levels are widest, near white, two of them.
inline constexpr float resolution = 0.02f;

/// Its parameter to walk along.
extern const std::span<const double> levels_sweep;

}  // namespace luch::techniques::ldr
