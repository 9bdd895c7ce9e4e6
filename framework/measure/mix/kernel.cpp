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

template <class T>
void mix_in_place(T* __restrict a, const T* __restrict b, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) a[i] = half(a[i], b[i]);
}

float composed(float albedo, float a, float b, float c, float highlights, float rest) {
    return albedo * (a + b + c) + highlights + rest;
}

/// A sum that ran over is less than what went into it: filled in bytes, without wider numbers.
std::uint8_t saturated(std::uint8_t a, std::uint8_t b) {
    const auto sum = static_cast<std::uint8_t>(a + b);
    return sum < a ? std::uint8_t{255} : sum;
}
std::uint8_t product(std::uint8_t a, std::uint8_t b) {
    const auto t = static_cast<std::uint16_t>(a * b + 128);
    return static_cast<std::uint8_t>(static_cast<std::uint16_t>(t + (t >> 8)) >> 8);
}
std::uint8_t composed(std::uint8_t albedo, std::uint8_t a, std::uint8_t b, std::uint8_t c,
                      std::uint8_t highlights, std::uint8_t rest) {
    return saturated(saturated(product(albedo, saturated(saturated(a, b), c)), highlights), rest);
}

template <class T>
void compose(const Planes<T>& planes, std::size_t n) {
    const T *__restrict albedo = planes.albedo, *__restrict a = planes.lights[0],
                        *__restrict b = planes.lights[1], *__restrict c = planes.lights[2],
                        *__restrict highlights = planes.highlights, *__restrict rest = planes.rest;
    T* __restrict to = planes.to;
    for (std::size_t i = 0; i < n; ++i) {
        to[i] = composed(albedo[i], a[i], b[i], c[i], highlights[i], rest[i]);
    }
}

constexpr Kernels kernels{mix_alone<float>,           mix<float>,
                          mix_alone<std::uint8_t>,    mix<std::uint8_t>,
                          mix_alone<std::uint32_t>,   mix_alone<std::uint64_t>,
                          mix<std::uint32_t>,         mix_in_place<float>,
                          mix_in_place<std::uint8_t>, compose<float>,
                          compose<std::uint8_t>};

}  // namespace

#define LUCH_NAME_OF(level) kernels_##level
#define LUCH_NAME(level) LUCH_NAME_OF(level)

const Kernels& LUCH_NAME(LUCH_LEVEL)() {
    return kernels;
}

}  // namespace luch::mix
