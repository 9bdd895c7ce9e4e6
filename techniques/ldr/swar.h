#pragma once

#include "techniques/ldr/word.h"

// All that can be done with a word. All four channels are worked on in the word (SWAR: SIMD within a
// register); nothing here has a branch, so loops over these become vector instructions. Formulas:
// Warren, "Hacker's Delight", 2nd edition, 2012, sections 2-5, 2-18.
namespace luch::techniques::ldr {

namespace swar {
/// Every channel's lowest bit, highest bit, and all but those.
inline constexpr std::uint32_t lowest = 0x01010101u, highest = 0x80808080u;
/// Every other channel: blue and red, with room for 16 bits each.
inline constexpr std::uint32_t pair = 0x00ff00ffu;

/// round(t / 255) of two numbers 0 ≤ t ≤ 255² in the halves of a word, where 128 was added to each
/// already: (t + t/256)/256, exact for all of them.
LUCH_LDR_INLINE std::uint32_t divided(std::uint32_t t) {
    return (t + (t >> 8 & pair)) >> 8 & pair;
}
}  // namespace swar

/// Σ, no more than 255 a channel. Carries stay within their channel: the highest bits are added by
/// themselves, and where one is carried out the channel is filled.
LUCH_LDR_INLINE Word operator+(Word a, Word b) {
    const std::uint32_t low = (a.bits & ~swar::highest) + (b.bits & ~swar::highest);
    const std::uint32_t sum = low ^ ((a.bits ^ b.bits) & swar::highest);
    const std::uint32_t out = ((a.bits & b.bits) | ((a.bits | b.bits) & ~sum)) & swar::highest;
    return Word(sum | (out >> 7) * 255u);
}

/// Two channels: t = a·b + 128; (t + t/256)/256 is round(a·b/255) for all 65,536 pairs. (a·b/256 is
/// wrong for 47,056 of them, and makes white times white 254.)
LUCH_LDR_INLINE std::uint32_t product(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t t = a * b + 128u;
    return (t + (t >> 8)) >> 8;
}

/// Channel times channel, rounded to nearest.
LUCH_LDR_INLINE Word operator*(Word a, Word b) {
    return {product(a.channel(3), b.channel(3)), product(a.channel(2), b.channel(2)),
            product(a.channel(1), b.channel(1)), product(a.channel(0), b.channel(0))};
}

/// Every channel times s/255, rounded to nearest; 0 ≤ s ≤ 255.
LUCH_LDR_INLINE Word scaled(Word a, std::uint32_t s) {
    const std::uint32_t half = 0x00800080u;
    const std::uint32_t even = swar::divided((a.bits & swar::pair) * s + half);
    const std::uint32_t odd = swar::divided((a.bits >> 8 & swar::pair) * s + half);
    return Word(odd << 8 | even);
}

/// a + (b − a)·t/255, rounded to nearest; t = 0 gives a, 255 gives b.
LUCH_LDR_INLINE Word lerp(Word a, Word b, std::uint32_t t) {
    const std::uint32_t s = 255u - t, half = 0x00800080u;
    const std::uint32_t even =
        swar::divided((a.bits & swar::pair) * s + (b.bits & swar::pair) * t + half);
    const std::uint32_t odd =
        swar::divided((a.bits >> 8 & swar::pair) * s + (b.bits >> 8 & swar::pair) * t + half);
    return Word(odd << 8 | even);
}

/// The lecture's half and half. Each of the two is halved by itself, so two lowest bits are lost:
/// mean error −½, worst −1, white with white is 254; and there is no alpha.
LUCH_LDR_INLINE Word half_of_lecture(Word a, Word b) {
    return Word((a.bits >> 1 & 0x7f7f7fu) + (b.bits >> 1 & 0x7f7f7fu));
}

/// Half and half, rounded down: a + b = 2(a & b) + (a ^ b). Mean error −¼, worst −½.
LUCH_LDR_INLINE Word half_down(Word a, Word b) {
    return Word((a.bits & b.bits) + ((a.bits ^ b.bits) >> 1 & ~swar::highest));
}

/// Half and half, rounded up: a + b = 2(a | b) − (a ^ b). Mean error +¼, worst +½.
LUCH_LDR_INLINE Word half_up(Word a, Word b) {
    return Word((a.bits | b.bits) - ((a.bits ^ b.bits) >> 1 & ~swar::highest));
}

/// Rounded down where up = 0, up where it is 1. Done in turn, pixel by pixel, that has no bias.
LUCH_LDR_INLINE Word half(Word a, Word b, std::uint32_t up) {
    return Word(half_down(a, b).bits + ((a.bits ^ b.bits) & swar::lowest & (0u - up)));
}

}  // namespace luch::techniques::ldr
