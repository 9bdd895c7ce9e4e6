#include "framework/measure/mix/kernels.h"

// Compiled once for every level, see luch_kernels(). No intrinsics: what is fast here is what the
// compiler makes of plain loops over the right representation.
namespace luch::mix {
namespace {

/// Hides where a loop is from the compiler, so that it does one turn after the other, without
/// vector instructions.
[[gnu::always_inline]] inline std::size_t alone(std::size_t i) {
    asm("" : "+r"(i));
    return i;
}

float half(float a, float b) {
    return 0.5f * (a + b);
}

/// In vectors this is one instruction, the rounded average of bytes.
std::uint8_t half(std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>((a + b + 1) >> 1);
}

/// All channels of an integer at once, rounded up: a + b = 2 (a | b) − (a ^ b). The mask keeps the
/// lowest bit of a channel out of its neighbour (Warren, "Hacker's Delight", 2nd edition, 2012,
/// section 2-5).
std::uint32_t half(std::uint32_t a, std::uint32_t b) {
    return (a | b) - (((a ^ b) & 0xfefefefeu) >> 1);
}
std::uint64_t half(std::uint64_t a, std::uint64_t b) {
    return (a | b) - (((a ^ b) & 0xfefefefefefefefeu) >> 1);
}

template <class T>
void mix_alone(const T* a, const T* b, T* to, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t at = alone(i);
        to[at] = half(a[at], b[at]);
    }
}

template <class T>
void mix(const T* __restrict a, const T* __restrict b, T* __restrict to, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) to[i] = half(a[i], b[i]);
}

constexpr Kernels kernels{mix_alone<float>,         mix<float>,
                          mix_alone<std::uint8_t>,  mix<std::uint8_t>,
                          mix_alone<std::uint32_t>, mix_alone<std::uint64_t>,
                          mix<std::uint32_t>};

}  // namespace

#define LUCH_NAME_OF(level) kernels_##level
#define LUCH_NAME(level) LUCH_NAME_OF(level)

const Kernels& LUCH_NAME(LUCH_LEVEL)() {
    return kernels;
}

}  // namespace luch::mix
