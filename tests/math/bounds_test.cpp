#include "framework/math/bounds.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

TEST(Bounds, AreEmptyUntilTheyGrow) {
    Box box;
    EXPECT_TRUE(box.empty());
    EXPECT_EQ(box.half_area(), 0);
    box.grow(Vec3(1, 2, 3));
    EXPECT_FALSE(box.empty());
    EXPECT_EQ(box.lo, Vec3(1, 2, 3));
    EXPECT_EQ(box.hi, Vec3(1, 2, 3));
}

TEST(Bounds, HoldEverythingTheyGrewBy) {
    Box box;
    box.grow(Vec3(1, 2, 3));
    box.grow(Box{{-1, 4, 3}, {0, 5, 3}});
    EXPECT_EQ(box.lo, Vec3(-1, 2, 3));
    EXPECT_EQ(box.hi, Vec3(1, 5, 3));
    EXPECT_EQ(box.centre(), Vec3(0, 3.5, 3));
    EXPECT_EQ(box.half_area(), 2 * 3 + 3 * 0 + 0 * 2);
}

}  // namespace
}  // namespace luch
