#include "framework/math/rng.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace luch {
namespace {

/// Pearson's statistic of counts that should all be equal.
template <std::size_t N>
double chi_squared(const std::array<int, N>& counts, int drawn) {
    const double expected = static_cast<double>(drawn) / N;
    double sum = 0;
    for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
    return sum;
}

// With 99 degrees of freedom the statistic exceeds 148.2 once in a thousand.
constexpr double once_in_a_thousand = 148.2;

TEST(Key, GivesTheSameNumberForTheSamePurpose) {
    EXPECT_EQ(Key(7).branch(3).uniform(5), Key(7).branch(3).uniform(5));
}

TEST(Key, TellsSeedBranchesAndPurposesApart) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t a = 0; a < 16; ++a) {
        for (std::uint64_t b = 0; b < 16; ++b) {
            for (std::uint64_t c = 0; c < 16; ++c) seen.insert(Key(a).branch(b).bits(c));
        }
    }
    EXPECT_EQ(seen.size(), 16u * 16 * 16);
}

TEST(Key, DependsOnTheOrderOfItsSeedAndBranches) {
    EXPECT_NE(Key(1).branch(2).bits(0), Key(2).branch(1).bits(0));
    EXPECT_NE(Key(1).branch(1).bits(0), Key(2).branch(2).bits(0));
    EXPECT_NE(Key(1).branch(2).branch(3).bits(0), Key(1).branch(3).branch(2).bits(0));
}

TEST(Key, IsUniformOverPurposes) {
    std::array<int, 100> counts{};
    constexpr int drawn = 100000;
    for (int i = 0; i < drawn; ++i) {
        const double x = Key(1).uniform(i);
        ASSERT_GE(x, 0);
        ASSERT_LT(x, 1);
        ++counts[static_cast<std::size_t>(x * 100)];
    }
    EXPECT_LT(chi_squared(counts, drawn), once_in_a_thousand);
}

TEST(Key, IsUniformInTheSquareOverBranches) {
    std::array<int, 100> counts{};
    constexpr int drawn = 100000;
    for (int i = 0; i < drawn; ++i) {
        const Vec2d p = Key(2).branch(i).square(3);
        ++counts[static_cast<std::size_t>(p.x * 10) * 10 + static_cast<std::size_t>(p.y * 10)];
    }
    EXPECT_LT(chi_squared(counts, drawn), once_in_a_thousand);
}

}  // namespace
}  // namespace luch
