#include "framework/math/spread.h"

#include <numbers>

namespace luch {
namespace {

std::uint32_t reversed(std::uint32_t bits) {
    bits = (bits << 16) | (bits >> 16);
    bits = ((bits & 0x00ff00ffu) << 8) | ((bits & 0xff00ff00u) >> 8);
    bits = ((bits & 0x0f0f0f0fu) << 4) | ((bits & 0xf0f0f0f0u) >> 4);
    bits = ((bits & 0x33333333u) << 2) | ((bits & 0xccccccccu) >> 2);
    return ((bits & 0x55555555u) << 1) | ((bits & 0xaaaaaaaau) >> 1);
}

/// Flips every bit by a hash of the bits above it: Laine and Karras, "Stratified Sampling for
/// Stochastic Transparency" (2011), with Burley's constants; it works on reversed bits, where every
/// step lets a bit depend on lower ones only.
std::uint32_t owen_scrambled(std::uint32_t bits, std::uint32_t seed) {
    std::uint32_t x = reversed(bits);
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reversed(x);
}

/// The second dimension of Sobol's sequence, for which v_0 = 2³¹ and v_k = v_(k−1) ^ (v_(k−1) >>
/// 1): in reversed bits v_k is the polynomial (1 + x)^k over the field of two elements, so the sum
/// over the index's bits is a polynomial shifted by 1. Shifted by halves: x^2m becomes x^2m + 1.
std::uint32_t sobol_second(std::uint32_t index) {
    index ^= index >> 16;
    index ^= (index >> 8) & 0x00ff00ffu;
    index ^= (index >> 4) & 0x0f0f0f0fu;
    index ^= (index >> 2) & 0x33333333u;
    index ^= (index >> 1) & 0x55555555u;
    return reversed(index);
}

}  // namespace

Vec2d spread(Key key, std::uint32_t index) {
    const std::uint64_t first = key.bits(0), second = key.bits(1);
    const std::uint32_t at = owen_scrambled(index, static_cast<std::uint32_t>(first >> 32));
    const std::uint32_t x = owen_scrambled(reversed(at), static_cast<std::uint32_t>(second >> 32));
    const std::uint32_t y = owen_scrambled(sobol_second(at), static_cast<std::uint32_t>(second));
    return {x * 0x1p-32, y * 0x1p-32};
}

Vec2d disc_of(const Vec2d& square) {
    const Vec2d p = 2.0 * square - 1.0;
    if (p == Vec2d(0)) return p;
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const double radius = wide ? p.x : p.y;
    const double turn = wide ? std::numbers::pi / 4 * (p.y / p.x)
                             : std::numbers::pi / 2 - std::numbers::pi / 4 * (p.x / p.y);
    return {radius * std::cos(turn), radius * std::sin(turn)};
}

}  // namespace luch
