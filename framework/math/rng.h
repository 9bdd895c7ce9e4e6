#pragma once

#include "framework/math/vec.h"

#include <cstdint>

namespace luch {

/// A counter-based random key. A number is hash(pixel, sample, path of branches, purpose): it
/// depends on what it is for, never on how many were drawn before, so threads, tile order and
/// stages that are left out cannot shift it. The mixing function is the 64-bit finaliser of
/// SplitMix64 (Steele, Lea, Flood 2014, variant 13 of Stafford).
class Key {
 public:
    Key() = default;
    explicit Key(std::uint64_t seed) : state_(mixed(seed + golden)) {}

    /// The key of a sub-decision: pixel, sample, light, bounce…
    [[nodiscard]] Key branch(std::uint64_t which) const {
        Key key;
        // The sum keeps seed and branch apart: without it Key(a).branch(b) is Key(b).branch(a).
        key.state_ = mixed((state_ + golden) ^ mixed(which + golden));
        return key;
    }
    [[nodiscard]] std::uint64_t bits(std::uint64_t purpose) const { return branch(purpose).state_; }
    /// In [0, 1), a multiple of 2⁻⁵³.
    [[nodiscard]] double uniform(std::uint64_t purpose) const {
        return static_cast<double>(bits(purpose) >> 11) * 0x1p-53;
    }
    /// A point of the unit square.
    [[nodiscard]] Vec2d square(std::uint64_t purpose) const {
        return {uniform(2 * purpose), uniform(2 * purpose + 1)};
    }

 private:
    static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;
    static constexpr std::uint64_t mixed(std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
        x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
        return x ^ (x >> 31);
    }
    std::uint64_t state_ = 0;
};

}  // namespace luch
