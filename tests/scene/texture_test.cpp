#include "framework/scene/texture.h"

#include <gtest/gtest.h>

#include <limits>

namespace luch {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Rgb grey(float value) {
    return Rgb(value);
}

TEST(Checker, ChangesColourEveryScalingUnits) {
    const Texture checker = CheckerTexture{Rgb(1, 0, 0), Rgb(0, 1, 0), 5};
    const Rgb first(1, 0, 0), second(0, 1, 0);
    EXPECT_EQ(colour_at(checker, {{1, 1}}), first);
    EXPECT_EQ(colour_at(checker, {{6, 1}}), second);
    EXPECT_EQ(colour_at(checker, {{6, 6}}), first);
    EXPECT_EQ(colour_at(checker, {{4.999, 0}}), first);
    EXPECT_EQ(colour_at(checker, {{5, 0}}), second);
}

TEST(Checker, GoesOnBelowZeroWithoutADoubleSquare) {
    const Texture checker = CheckerTexture{Rgb(1, 0, 0), Rgb(0, 1, 0), 5};
    EXPECT_EQ(colour_at(checker, {{-1, 1}}), Rgb(0, 1, 0));
    EXPECT_EQ(colour_at(checker, {{-1, -1}}), Rgb(1, 0, 0));
    EXPECT_EQ(colour_at(checker, {{-6, 1}}), Rgb(1, 0, 0));
}

/// 2 × 2: 0 1 over 2 3.
BitmapTexture small(double scaling) {
    BitmapTexture bitmap{Image<Rgb>({2, 2}), scaling};
    for (int i = 0; i < 4; ++i) bitmap.pixels(i % 2, i / 2) = grey(static_cast<float>(i));
    return bitmap;
}

TEST(Bitmap, HasItsPixelsAtTheirTopLeftCorners) {
    const Texture bitmap = small(10);
    EXPECT_EQ(colour_at(bitmap, {{0, 0}}), grey(0));
    EXPECT_EQ(colour_at(bitmap, {{5, 0}}), grey(1));
    EXPECT_EQ(colour_at(bitmap, {{0, 5}}), grey(2));
    EXPECT_EQ(colour_at(bitmap, {{5, 5}}), grey(3));
}

TEST(Bitmap, IsBilinearAndWrapsAtItsEnds) {
    const Texture bitmap = small(10);
    // (1.25, 2.5) is pixel (0.25, 0.5): the rows give 0.25 and 2.25, their middle 1.25.
    EXPECT_FLOAT_EQ(colour_at(bitmap, {{1.25, 2.5}}).r, 1.25f);
    // (7.5, 0) is pixel (1.5, 0): between pixel 1 and, around the end, pixel 0.
    EXPECT_FLOAT_EQ(colour_at(bitmap, {{7.5, 0}}).r, 0.5f);
    EXPECT_FLOAT_EQ(colour_at(bitmap, {{0, 7.5}}).r, 1.0f);
}

TEST(Bitmap, RepeatsInBothDirections) {
    const Texture bitmap = small(10);
    for (const double shift : {-30.0, -10.0, 10.0, 2000.0}) {
        EXPECT_FLOAT_EQ(colour_at(bitmap, {{1.25 + shift, 2.5 - shift}}).r, 1.25f) << shift;
    }
}

TEST(Bitmap, HasSomeFiniteColourEverywhere) {
    const Texture bitmap = small(10);
    for (const double u : {infinity, -infinity, std::nan(""), 1e300, -1e-300}) {
        const Rgb colour = colour_at(bitmap, {{u, -u}});
        EXPECT_TRUE(all_finite(colour)) << u;
        EXPECT_LE(colour.r, 3) << u;
    }
    EXPECT_EQ(colour_at(BitmapTexture{}, {{0.5, 0.5}}), grey(0));
}

TEST(Slopes, AreDifferencesToTheRightAndBelowThatWrap) {
    Image<Rgb> heights({2, 2});
    heights(0, 0) = Rgb(0.3f, 0.6f, 0.9f);  // grey 0.6
    heights(1, 0) = grey(0.1f);
    heights(0, 1) = grey(0.2f);
    heights(1, 1) = grey(1);
    const Image<Vec2> slopes = slopes_of(heights.view());
    EXPECT_FLOAT_EQ(slopes(0, 0).x, 0.5f);
    EXPECT_FLOAT_EQ(slopes(0, 0).y, 0.4f);
    EXPECT_FLOAT_EQ(slopes(1, 0).x, -0.5f);
    EXPECT_FLOAT_EQ(slopes(1, 0).y, -0.9f);
    EXPECT_FLOAT_EQ(slopes(1, 1).x, 0.8f);
    EXPECT_FLOAT_EQ(slopes(1, 1).y, 0.9f);
}

BumpTexture bump() {
    BumpTexture texture{Image<Vec2>({4, 2}), 3, 0.5};
    texture.slopes(1, 0) = {0.2f, 0.4f};
    return texture;
}

TEST(Bump, IsLookedUpAtTheCoordinateTimesScaling) {
    // (0.5, 0) · 0.5 · (4, 2) is pixel (1, 0).
    const Vec2d tilt = tilt_at(bump(), {0.5, 0});
    EXPECT_NEAR(tilt.x, 0.6, 1e-6);
    EXPECT_NEAR(tilt.y, 1.2, 1e-6);
    // Half-way to the next pixel, which is flat.
    EXPECT_NEAR(tilt_at(bump(), {0.75, 0}).x, 0.3, 1e-6);
}

TEST(Bump, RepeatsAtNegativeCoordinatesToo) {
    // A period is 1 / scaling = 2.
    EXPECT_NEAR(tilt_at(bump(), {0.5 - 2, -4}).x, 0.6, 1e-6);
    EXPECT_NEAR(tilt_at(bump(), {-1.5, 0}).y, 1.2, 1e-6);
}

TEST(Bump, HasNoColourAndOtherTexturesHaveNoTilt) {
    EXPECT_EQ(colour_at(bump(), {{0.5, 0}}), grey(0));
    EXPECT_EQ(tilt_at(small(10), {1, 1}), Vec2d(0));
}

}  // namespace
}  // namespace luch
