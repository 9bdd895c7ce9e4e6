#pragma once

#include <cstdint>

// A colour in one 32-bit word. What can be done with it: swar.h.
namespace luch::techniques::ldr {

#define LUCH_LDR_INLINE [[nodiscard, gnu::always_inline]] constexpr inline

/// 0xAARRGGBB: alpha, red, green, blue, 0…255 each; 255 is 1.
struct Word {
    std::uint32_t bits = 0;

    Word() = default;
    constexpr explicit Word(std::uint32_t all) : bits(all) {}
    constexpr Word(std::uint32_t a, std::uint32_t r, std::uint32_t g, std::uint32_t b)
        : bits(a << 24 | r << 16 | g << 8 | b) {}

    /// 0: blue, 1: green, 2: red, 3: alpha.
    [[nodiscard]] constexpr std::uint32_t channel(int i) const { return bits >> (8 * i) & 255u; }
    [[nodiscard]] constexpr std::uint32_t alpha() const { return bits >> 24; }
    bool operator==(const Word&) const = default;
};

}  // namespace luch::techniques::ldr
