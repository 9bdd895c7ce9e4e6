#include "framework/math/spread.h"

#include <gtest/gtest.h>

#include <set>

namespace luch {
namespace {

TEST(Spread, PutsOnePointIntoEveryElementaryBox) {
    for (int seed = 0; seed < 20; ++seed) {
        constexpr int m = 6, count = 1 << m;
        for (int columns = 0; columns <= m; ++columns) {
            std::set<int> boxes;
            for (int i = 0; i < count; ++i) {
                const Vec2d p = spread(Key(seed), i);
                ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
                const int column = static_cast<int>(std::ldexp(p.x, columns));
                const int row = static_cast<int>(std::ldexp(p.y, m - columns));
                boxes.insert(column << (m - columns) | row);
            }
            EXPECT_EQ(boxes.size(), static_cast<std::size_t>(count)) << seed << " " << columns;
        }
    }
}

TEST(Spread, IsUniformAtEveryPlaceOfTheSequence) {
    // The mean of 4000 uniform numbers has a standard deviation of 0.0046, of their squares 0.0047.
    constexpr int keys = 4000;
    for (const std::uint32_t index : {0u, 1u, 2u, 5u, 31u}) {
        Vec2d sum(0), squares(0);
        for (int key = 0; key < keys; ++key) {
            const Vec2d p = spread(Key(9).branch(key), index);
            sum += p;
            squares += p * p;
        }
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_NEAR(sum[axis] / keys, 0.5, 0.02) << index;
            EXPECT_NEAR(squares[axis] / keys, 1.0 / 3, 0.02) << index;
        }
    }
}

TEST(Spread, HasNothingToDoWithAnotherKeysPoints) {
    double product = 0;
    constexpr int keys = 200, points = 16;
    for (int key = 0; key < keys; ++key) {
        for (int i = 0; i < points; ++i) {
            const Vec2d a = spread(Key(1).branch(key), i), b = spread(Key(2).branch(key), i);
            product += (a.x - 0.5) * (b.x - 0.5) * 12;
        }
    }
    EXPECT_NEAR(product / (keys * points), 0, 0.07);  // four standard deviations
}

TEST(Disc, KeepsTheShareOfEveryRing) {
    int inner = 0;
    constexpr int count = 4096;
    for (int i = 0; i < count; ++i) {
        const Vec2d p = disc_of(spread(Key(3), i));
        ASSERT_LE(glm::length(p), 1 + 1e-12);
        inner += glm::length(p) < 0.5 ? 1 : 0;
    }
    EXPECT_NEAR(inner / double(count), 0.25, 0.01);
    EXPECT_EQ(disc_of(Vec2d(0.5)), Vec2d(0));
    EXPECT_NEAR(glm::length(disc_of({0, 0})), 1, 1e-15);
}

}  // namespace
}  // namespace luch
