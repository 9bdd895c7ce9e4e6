#include "techniques/ldr/spans.h"

#include "techniques/ldr/swar.h"

// Compiled once for every level. No intrinsics: what is fast here is what the compiler makes of
// plain loops over the right representation.
namespace luch::techniques::ldr {
namespace {

void add(Word* __restrict a, const Word* __restrict b, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) a[i] = a[i] + b[i];
}

/// Byte by byte: so a vector holds twice as many channels as words' channels would be.
void modulate(Word* __restrict a, const Word* __restrict b, std::size_t n) {
    auto* to = reinterpret_cast<unsigned char*>(a);
    const auto* by = reinterpret_cast<const unsigned char*>(b);
    for (std::size_t i = 0; i < 4 * n; ++i) {
        const auto t = static_cast<std::uint16_t>(to[i] * by[i] + 128);
        to[i] = static_cast<unsigned char>(static_cast<std::uint16_t>(t + (t >> 8)) >> 8);
    }
}

void mix(Word* __restrict a, const Word* __restrict b, const std::uint8_t* __restrict up,
         std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) a[i] = half(a[i], b[i], up[i]);
}

void lerp_all(Word* __restrict a, const Word* __restrict b, const std::uint8_t* __restrict alpha,
              std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) a[i] = lerp(a[i], b[i], alpha[i]);
}

void accumulate(const Word* __restrict words, Wide* __restrict sums, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
        for (int c = 0; c < 4; ++c) {
            sums[i].channel[c] = plus(sums[i].channel[c], words[i].channel(c) * Wide::level);
        }
    }
}

void tint(Wide* __restrict sums, const Word* __restrict albedo,
          const std::uint32_t* __restrict linear, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
        for (int c = 0; c < 3; ++c) {
            const std::uint64_t t =
                std::uint64_t{sums[i].channel[c]} * linear[albedo[i].channel(c)];
            sums[i].channel[c] = static_cast<std::uint32_t>((t + 32'767) / 65'535);
        }
    }
}

constexpr Spans spans{add, modulate, mix, lerp_all, accumulate, tint};

}  // namespace

#define LUCH_NAME_OF(level) spans_##level
#define LUCH_NAME(level) LUCH_NAME_OF(level)

const Spans& LUCH_NAME(LUCH_LEVEL)() {
    return spans;
}

}  // namespace luch::techniques::ldr
