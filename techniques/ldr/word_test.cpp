#include "techniques/ldr/swar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace luch::techniques::ldr {
namespace {

/// Every pair of two channels, in all four places of a word at once, each in another order, so that
/// every channel has other neighbours.
void for_all_pairs(const std::function<void(Word, Word)>& work) {
    for (std::uint32_t a = 0; a < 256; ++a) {
        for (std::uint32_t b = 0; b < 256; ++b) {
            work({a, b, 255 - a, a ^ 0x55u}, {b, a, b, 255 - b});
        }
    }
}

/// What an operation must give, channel by channel.
void expect_by_channel(const std::function<Word(Word, Word)>& operation,
                       const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& exact) {
    for_all_pairs([&](Word a, Word b) {
        const Word got = operation(a, b);
        for (int c = 0; c < 4; ++c) {
            ASSERT_EQ(got.channel(c), exact(a.channel(c), b.channel(c)))
                << std::hex << a.bits << ' ' << b.bits << " channel " << c;
        }
    });
}

std::uint32_t nearest(double value) {
    return static_cast<std::uint32_t>(std::floor(value + 0.5));
}

TEST(Word, AddsWithSaturationAndWithoutCarries) {
    EXPECT_EQ((Word(0, 200, 0, 0) + Word(0, 100, 0, 0)), Word(0, 255, 0, 0));
    EXPECT_EQ(Word(0x00ff00ffu) + Word(0x01010101u), Word(0x01ff01ffu));
    expect_by_channel([](Word a, Word b) { return a + b; },
                      [](std::uint32_t a, std::uint32_t b) { return std::min(a + b, 255u); });
}

TEST(Word, MultipliesExactlyOverAllPairs) {
    expect_by_channel([](Word a, Word b) { return a * b; },
                      [](std::uint32_t a, std::uint32_t b) { return nearest(a * b / 255.0); });
}

/// What the shift by eight alone would cost.
TEST(Word, WouldBeWrongForMostPairsWithAShiftAlone) {
    int wrong = 0;
    for (std::uint32_t a = 0; a < 256; ++a) {
        for (std::uint32_t b = 0; b < 256; ++b) {
            wrong += (a * b >> 8) == product(a, b) ? 0 : 1;
        }
    }
    EXPECT_EQ(wrong, 47'056);
}

TEST(Word, ScalesAndLerpsToTheNearestLevel) {
    for (std::uint32_t t = 0; t < 256; ++t) {
        for (std::uint32_t a = 0; a < 256; ++a) {
            const std::uint32_t b = (a * 37 + t * 11) & 255;
            const Word from(a, b, 255 - a, 0), to(b, a, 255, 255 - b);
            const Word half_way = lerp(from, to, t), part = scaled(from, t);
            for (int c = 0; c < 4; ++c) {
                const double x = from.channel(c), y = to.channel(c);
                ASSERT_EQ(half_way.channel(c), nearest((x * (255 - t) + y * t) / 255));
                ASSERT_EQ(part.channel(c), nearest(x * t / 255));
            }
        }
    }
}

TEST(Word, LerpsFromOneEndToTheOtherExactly) {
    for_all_pairs([](Word a, Word b) {
        ASSERT_EQ(lerp(a, b, 0), a);
        ASSERT_EQ(lerp(a, b, 255), b);
    });
}

/// Mean and worst error of a half-and-half mix, in levels, over all pairs.
struct Bias {
    double mean = 0, worst = 0;
};
Bias bias_of(const std::function<Word(Word, Word)>& mix) {
    Bias bias;
    for (std::uint32_t a = 0; a < 256; ++a) {
        for (std::uint32_t b = 0; b < 256; ++b) {
            const double off = mix(Word(a, a, a, a), Word(b, b, b, b)).channel(1) - (a + b) / 2.0;
            bias.mean += off / 65'536;
            if (std::abs(off) > std::abs(bias.worst)) bias.worst = off;
        }
    }
    return bias;
}

TEST(Mix, OfTheLectureLosesHalfALevelAndAlpha) {
    const Bias bias = bias_of(half_of_lecture);
    EXPECT_DOUBLE_EQ(bias.mean, -0.5);
    EXPECT_EQ(bias.worst, -1);
    EXPECT_EQ(half_of_lecture(Word(~0u), Word(~0u)), Word(0, 254, 254, 254));
}

TEST(Mix, RoundedDownOrUpIsOffByAQuarterAndKeepsAlpha) {
    const Bias down = bias_of(half_down), up = bias_of(half_up);
    EXPECT_DOUBLE_EQ(down.mean, -0.25);
    EXPECT_EQ(down.worst, -0.5);
    EXPECT_DOUBLE_EQ(up.mean, 0.25);
    EXPECT_EQ(up.worst, 0.5);
    EXPECT_EQ(half_down(Word(~0u), Word(~0u)), Word(~0u));
}

TEST(Mix, InTurnHasNoBias) {
    const Bias down = bias_of([](Word a, Word b) { return half(a, b, 0); });
    const Bias up = bias_of([](Word a, Word b) { return half(a, b, 1); });
    EXPECT_DOUBLE_EQ(down.mean + up.mean, 0);
    EXPECT_LE(std::max(-down.worst, up.worst), 0.5);
}

TEST(Mix, HasNoCarryBetweenChannels) {
    const auto floor = [](std::uint32_t a, std::uint32_t b) { return (a + b) / 2; };
    const auto ceiling = [](std::uint32_t a, std::uint32_t b) { return (a + b + 1) / 2; };
    expect_by_channel(half_down, floor);
    expect_by_channel(half_up, ceiling);
    expect_by_channel([](Word a, Word b) { return half(a, b, 0); }, floor);
    expect_by_channel([](Word a, Word b) { return half(a, b, 1); }, ceiling);
}

/// N truncations drift by N/2 levels, N roundings walk by about √N/√12.
TEST(Rounding, DriftsWhenItTruncatesAndWalksWhenItDoesNot) {
    constexpr int steps = 64;
    double drift = 0, walk = 0;
    int count = 0;
    for (std::uint32_t start = 200; start < 256; ++start) {
        double exact = start;
        std::uint32_t cut = start, rounded = start;
        for (int i = 0; i < steps; ++i) {
            const std::uint32_t by = 250 + static_cast<std::uint32_t>(i * 7 % 6);
            exact = exact * by / 255;
            cut = cut * by / 255;
            rounded = product(rounded, by);
        }
        drift += cut - exact;
        walk += (rounded - exact) * (rounded - exact);
        ++count;
    }
    // Later factors take some of what earlier ones lost.
    EXPECT_LT(drift / count, -steps / 4.0);
    EXPECT_GT(drift / count, -steps / 2.0);
    EXPECT_LT(std::sqrt(walk / count), std::sqrt(steps / 12.0) + 1);
}

}  // namespace
}  // namespace luch::techniques::ldr
