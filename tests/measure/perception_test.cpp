#include "framework/base/error.h"
#include "framework/measure/flicker.h"
#include "framework/measure/foveal.h"
#include "framework/measure/magma.h"
#include "tests/measure/patterns.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luch {
namespace {

using testing::altered_pattern;
using testing::pattern;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
const Gaze at_left{{0.5, 0.5}};

TEST(Foveal, AcuityIsHalfAtTwoDegreesAndAThird) {
    EXPECT_EQ(relative_acuity(0), 1);
    EXPECT_DOUBLE_EQ(relative_acuity(2.3), 0.5);
    EXPECT_DOUBLE_EQ(relative_acuity(20.7), 0.1);
}

TEST(Foveal, EccentricityIsAnAngleOnAFlatScreen) {
    // The eye is 67.02·180/π = 3840 pixels away.
    EXPECT_NEAR(eccentricity_deg({3840.5, 0.5}, at_left), 45, 1e-9);
    EXPECT_NEAR(eccentricity_deg({0.5, 67.52}, at_left), 0.99989, 1e-4);
}

TEST(Foveal, ErrorWeighsPixelsByTheirSquaredAcuity) {
    // One pixel at the gaze, the other where acuity is a half: 100 pixels per degree, 2.3° away.
    const int far = static_cast<int>(std::lround(std::tan(2.3 * M_PI / 180) * 100 * 180 / M_PI));
    Image<Rgb> reference({far + 1, 1}, Rgb(nan)), image = reference;
    reference(0, 0) = image(0, 0) = reference(far, 0) = image(far, 0) = Rgb(0.5f);
    image(far, 0) += Rgb(0.25f);
    const auto error = [&] { return foveal_rmse(reference.view(), image.view(), at_left, 100); };
    EXPECT_NEAR(error(), std::sqrt(0.25 * 0.0625 / 1.25), 1e-4);
    std::swap(image(0, 0), image(far, 0));
    EXPECT_NEAR(error(), std::sqrt(0.0625 / 1.25), 1e-4);
}

/// NumPy 1.24.2, from the formula; the gaze is at (4, 12).
TEST(Foveal, ErrorOfAPatternIsWhatTheFormulaGivesElsewhere) {
    EXPECT_NEAR(foveal_rmse(pattern({24, 17}).view(), altered_pattern({24, 17}).view(), {{4, 12}}),
                0.218014280, 1e-8);
}

TEST(Foveal, ErrorIsNoNumberWithoutAFinitePixel) {
    const Image<Rgb> image({2, 2}, Rgb(nan));
    EXPECT_TRUE(std::isnan(foveal_rmse(image.view(), image.view(), at_left)));
}

double flicker_of(const std::vector<Rgb>& references, const std::vector<Rgb>& frames) {
    Flicker flicker;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        flicker.add(Image<Rgb>({2, 2}, references[i]).view(), Image<Rgb>({2, 2}, frames[i]).view());
    }
    return flicker.mean();
}

TEST(Flicker, IsTheMeanChangeOfTheError) {
    // Errors 0, 0.5, 0.25 in one channel of three: changes 0.5 and 0.25.
    const std::vector<Rgb> still(3, Rgb(0.25f));
    EXPECT_DOUBLE_EQ(
        flicker_of(still, {Rgb(0.25f), Rgb(0.75f, 0.25f, 0.25f), Rgb(0.5f, 0.25f, 0.25f)}),
        0.75 / 6);
}

TEST(Flicker, IsZeroForAnErrorThatStandsStillWhileTheReferenceMoves) {
    EXPECT_EQ(flicker_of({Rgb(0), Rgb(0.5f), Rgb(0.125f)}, {Rgb(1), Rgb(1.5f), Rgb(1.125f)}), 0);
}

TEST(Flicker, IsNoNumberBeforeTheSecondFrame) {
    EXPECT_TRUE(std::isnan(flicker_of({Rgb(0)}, {Rgb(1)})));
}

TEST(Flicker, CountsPixelsThatAreNotFiniteApart) {
    Flicker flicker;
    const Image<Rgb> reference({2, 2});
    Image<Rgb> frame = reference;
    flicker.add(reference.view(), frame.view());
    frame(1, 0) = Rgb(nan);
    flicker.add(reference.view(), frame.view());
    EXPECT_EQ(flicker.mean(), 0);
    EXPECT_EQ(flicker.non_finite().count, 1u);
    EXPECT_EQ(flicker.non_finite().first_x, 1);
    EXPECT_EQ(flicker.non_finite().first_y, 0);
}

TEST(Flicker, RefusesAFrameOfAnotherSize) {
    Flicker flicker;
    flicker.add(Image<Rgb>({2, 2}).view(), Image<Rgb>({2, 2}).view());
    EXPECT_THROW(flicker.add(Image<Rgb>({3, 2}).view(), Image<Rgb>({3, 2}).view()), Error);
    EXPECT_THROW(flicker.add(Image<Rgb>({2, 2}).view(), Image<Rgb>({3, 2}).view()), Error);
}

TEST(Magma, GoesFromBlackToLightYellowAndBrightensAllTheWay) {
    EXPECT_EQ(magma(0), Rgb(0, 0, 4) / 255.0f);
    EXPECT_EQ(magma(1), Rgb(252, 253, 191) / 255.0f);
    EXPECT_EQ(magma(2), magma(1));
    float before = -1;
    for (int i = 0; i < 256; ++i) {
        const float brightness = glm::dot(srgb_decoded(magma(static_cast<float>(i) / 255)),
                                          Rgb(0.2126f, 0.7152f, 0.0722f));
        EXPECT_GE(brightness, before - 2e-3f) << i;
        before = brightness;
    }
}

TEST(Magma, ShowsAPixelWithoutAValueInGreen) {
    Image<float> map({2, 1}, 1.0f);
    map(1, 0) = nan;
    EXPECT_EQ(in_magma(map.view())(0, 0), magma(1));
    EXPECT_EQ(in_magma(map.view())(1, 0), Rgb(0, 1, 0));
}

}  // namespace
}  // namespace luch
