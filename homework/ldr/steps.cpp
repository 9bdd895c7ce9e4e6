// Homework: a colour in one word, step by step. This is the only file to edit; README.md (and
// README.bg.md) has the tasks. What is not written yet is done by the reference, so begin where you
// like. techniques/ldr/ldr.h says what each step is given and what it must leave behind.
#include "framework/technique/catalogue.h"
#include "framework/technique/todo.h"
#include "techniques/ldr/ldr.h"
#include "techniques/ldr/stress.h"

namespace luch::homework::ldr {
namespace {

using techniques::ldr::Misfits;
using techniques::ldr::Steps;
using techniques::ldr::Wide;
using techniques::ldr::Word;

/// t1. Multiply by the exposure, then clamp to 0…1, then round to 255 levels: ⌊255·x + ½⌋. Alpha is
/// 255. Count channels above 1 and channels that are no number (std::isnan); those become 0.
void encode(std::span<const Rgb> light, float exposure, std::span<Word> words, Misfits& misfits) {
    LUCH_TODO("ldr.t1");
}

/// t2. a ← a + b, at most 255 in every channel, alpha too. Word::bits are all four channels. One
/// integer addition would carry from channel to channel: add the low seven bits of each by
/// themselves, the highest ones without carry (^), and fill the channels that overflowed.
void add(std::span<Word> a, std::span<const Word> b) {
    LUCH_TODO("ldr.t2");
}

/// t3. a ← round(a·b/255) in every channel. No division: with t = a·b + 128 it is (t + (t>>8))
/// >> 8.
void modulate(std::span<Word> a, std::span<const Word> b) {
    LUCH_TODO("ldr.t3");
}

/// t4. a ← (a + b)/2 in every channel. (a & b) + ((a ^ b) >> 1) rounds down, if no bit is shifted
/// into the next channel; where up is 1, halves are rounded up instead.
void mix(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t> up) {
    LUCH_TODO("ldr.t4");
}

/// t5. a ← round((a·(255 − alpha) + b·alpha)/255) in every channel, alpha too. Two channels at a
/// time fit into a word: bits & 0x00ff00ff leaves room for 16 bits each.
void lerp(std::span<Word> a, std::span<const Word> b, std::span<const std::uint8_t> alpha) {
    LUCH_TODO("ldr.t5");
}

/// t6. Every channel of a sum grows by the word's, times Wide::level; it stays at the largest
/// number there is rather than begin again at 0. Wide::channel[i] belongs to Word::channel(i).
void accumulate(std::span<const Word> words, std::span<Wide> sums) {
    LUCH_TODO("ldr.t6");
}

/// t7. x = channel/(n·Wide::white), at most 1, is linear light. For the screen it goes through the
/// curve of sRGB (12.92·x up to 0.0031308, then 1.055·x^(1/2.4) − 0.055), and becomes the level
/// ⌊255·srgb(x) + dither/256⌋. Alpha has no curve and no dither: ⌊255·x + ½⌋.
void resolve(std::span<const Wide> sums, int n, std::span<const std::uint8_t> dither,
             std::span<Word> words) {
    LUCH_TODO("ldr.t7");
}

}  // namespace

/// What the technique is made of, and what `luch check ldr` tries.
Steps steps() {
    const Steps given = techniques::ldr::reference();
    return {encode, add, modulate, mix, lerp, accumulate, resolve, given.gather, given.tint};
}

TechniqueInfo describe() {
    return {.name = "homework/ldr",
            .title = "colours in words of 32 bits: yours",
            .topic = "2. LDR colour",
            .create = [] { return techniques::ldr::make(steps()); },
            .sweep = {"levels", techniques::ldr::levels_sweep, -1},
            .resolution = techniques::ldr::resolution,
            .stress_cases = techniques::ldr::stress_cases};
}

}  // namespace luch::homework::ldr
