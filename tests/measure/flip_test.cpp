#include "framework/measure/flip.h"

#include "framework/base/error.h"
#include "framework/image/io.h"
#include "framework/measure/flip_filters.h"
#include "tests/measure/patterns.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

namespace luch {
namespace {

using testing::altered_pattern;
using testing::pattern;
using testing::transposed;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

FlipResult ldr(const Image<Rgb>& reference, const Image<Rgb>& image) {
    return flip_ldr(reference.view(), image.view(), Workers(1));
}

HdrFlipResult hdr(const Image<Rgb>& reference, const Image<Rgb>& image) {
    return flip_hdr(reference.view(), image.view(), Workers(1));
}

/// LDR-FLIP of two colours that fill a picture.
double of_colours(const Rgb& a, const Rgb& b, Size size = {3, 2}) {
    return ldr(Image<Rgb>(size, a), Image<Rgb>(size, b)).mean;
}

Image<Rgb> scaled(Image<Rgb> image, float factor) {
    for (Rgb& pixel : image.pixels()) pixel *= factor;
    return image;
}

/// Light of a high range: 16·v⁴.
Image<Rgb> bright(Image<Rgb> image) {
    for (Rgb& v : image.pixels()) v = 16.0f * (v * v) * (v * v);
    return image;
}

/// Three means that the authors' implementation computed. It sums floats, which is what the
/// tolerance is for.
TEST(Flip, HasTheMeansOfTheReferenceImplementation) {
    const std::filesystem::path folder = LUCH_SOURCE_DIR "/../shared/flip";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
    const auto read = [&](const char* name) { return read_picture(folder / name).pixels; };
    EXPECT_NEAR(ldr(read("boxed.png"), read("boxed_blur.png")).mean, 0.039653, 1e-5);
    EXPECT_NEAR(ldr(read("Lecture8.png"), read("Lecture8_bright.png")).mean, 0.208271, 1e-5);
    EXPECT_NEAR(hdr(read("boxed.exr"), read("boxed_exp.exr")).flip.mean, 0.377374, 1e-5);
}

// The numbers of the next two come from a program of its own: NumPy 1.24.2, in double, with
// two-dimensional filters as the papers write them (scipy.ndimage.correlate, mode "nearest").

TEST(Flip, OfAPatternIsWhatTwoDimensionalFiltersInDoubleGive) {
    const FlipResult flip = ldr(pattern({24, 17}), altered_pattern({24, 17}));
    EXPECT_NEAR(flip.mean, 0.6220544, 1e-6);
    EXPECT_NEAR(flip.map(5, 3), 0.6783605, 1e-5);
    EXPECT_NEAR(flip.map(23, 16), 0.5587794, 1e-5);
}

TEST(Flip, OfBrightPatternsIsTheLargestOverTheExposures) {
    const HdrFlipResult result = hdr(bright(pattern({24, 17})), bright(altered_pattern({24, 17})));
    EXPECT_NEAR(result.flip.mean, 0.7671405, 1e-6);
    EXPECT_NEAR(result.flip.map(5, 3), 0.8097731, 1e-5);
    EXPECT_NEAR(result.start, -2.8430372, 1e-5);
    EXPECT_NEAR(result.stop, 0.0814561, 1e-5);
    EXPECT_EQ(result.exposures, 3);
}

TEST(Flip, OfEqualPicturesIsZeroEverywhere) {
    const Image<Rgb> image = pattern({24, 17});
    EXPECT_EQ(ldr(image, image).map, Image<float>({24, 17}));
    EXPECT_EQ(ldr(image, image).mean, 0);
    EXPECT_EQ(hdr(image, image).flip.map, Image<float>({24, 17}));
}

/// Where both pictures are of one colour no filter changes them and there is no edge, so the error
/// is that of the colours, to be had by hand: black and white are 100 apart; 100^0.7 = 25.119;
/// green and blue, the farthest apart, have 41.278; 0.95 + 0.05·(25.119 − 16.511)/(41.278
/// − 16.511). Rounding in the edge filters comes out under a square root: 1e-8 of an edge is 1e-4
/// here.
constexpr double of_flat_colours = 1e-4;

TEST(Flip, OfTwoColoursIsTheirDistance) {
    EXPECT_NEAR(of_colours(Rgb(0), Rgb(1)), 0.9673798, of_flat_colours);
    EXPECT_NEAR(of_colours(Rgb(0, 1, 0), Rgb(0, 0, 1)), 1, of_flat_colours);
    EXPECT_NEAR(of_colours(Rgb(1, 0, 0), Rgb(1, 1, 0)), 0.9771527, of_flat_colours);
    EXPECT_NEAR(of_colours(Rgb(0.5f), Rgb(0.6f)), 0.2850130, of_flat_colours);
    EXPECT_NEAR(of_colours(Rgb(0.1f, 0.2f, 0.3f), Rgb(0.2f, 0.2f, 0.3f)), 0.1392686,
                of_flat_colours);
}

TEST(Flip, OfOnePixelOrOneRowIsThatOfItsColour) {
    for (const Size size : {Size{1, 1}, Size{1, 40}, Size{40, 1}}) {
        EXPECT_NEAR(of_colours(Rgb(0.5f), Rgb(0.6f), size), 0.2850130, of_flat_colours);
    }
}

TEST(Flip, ClampsWhatADisplayCannotShow) {
    EXPECT_EQ(of_colours(Rgb(-3), Rgb(7)), of_colours(Rgb(0), Rgb(1)));
}

TEST(Flip, OfLdrIsSymmetric) {
    const Image<Rgb> a = pattern({24, 17}), b = altered_pattern({24, 17});
    EXPECT_EQ(ldr(a, b).map, ldr(b, a).map);
}

TEST(Flip, TreatsBothAxesAlike) {
    const Image<Rgb> a = pattern({30, 11}), b = altered_pattern({30, 11});
    const FlipResult upright = ldr(a, b), turned = ldr(transposed(a), transposed(b));
    for (int y = 0; y < 11; ++y) {
        for (int x = 0; x < 30; ++x) EXPECT_NEAR(upright.map(x, y), turned.map(y, x), 1e-5);
    }
}

/// Rows are worked on in bands of 64; a picture of several must not show them.
TEST(Flip, IsTheSameOnAnyNumberOfWorkersAndInAnyBand) {
    const Image<Rgb> a = pattern({20, 150}), b = altered_pattern({20, 150});
    const Image<float> alone = ldr(a, b).map;
    EXPECT_EQ(flip_ldr(a.view(), b.view(), Workers(3)).map, alone);
    Image<Rgb> lower_a({20, 100}), lower_b({20, 100});
    std::copy(a.pixels().begin() + 20 * 50, a.pixels().end(), lower_a.pixels().begin());
    std::copy(b.pixels().begin() + 20 * 50, b.pixels().end(), lower_b.pixels().begin());
    const Image<float> lower = ldr(lower_a, lower_b).map;
    for (int y = 10; y < 100; ++y) EXPECT_EQ(lower(7, y), alone(7, y + 50)) << y;
}

TEST(Flip, OfAPixelThatIsNotFiniteIsNaNAndItsNeighboursDoNotSeeIt) {
    const Image<Rgb> good = pattern({24, 17});
    Image<Rgb> broken = good;
    broken(10, 8) = Rgb(0, nan, 0);
    for (const auto& [a, b] : {std::pair(good, broken), std::pair(broken, good)}) {
        const FlipResult flip = ldr(a, b);
        EXPECT_EQ(flip.mean, 0);
        EXPECT_TRUE(std::isnan(flip.map(10, 8)));
        EXPECT_EQ(flip.map(11, 8), 0);
        EXPECT_EQ(hdr(a, b).flip.mean, 0);
    }
    EXPECT_TRUE(std::isnan(ldr(Image<Rgb>({2, 2}, Rgb(nan)), Image<Rgb>({2, 2})).mean));
}

TEST(Flip, ExposesFromTheBrightestPixelToTheMedian) {
    Image<Rgb> light({5, 5}, Rgb(0.25f));
    light(2, 2) = Rgb(4);
    const HdrFlipResult result = hdr(light, light);
    // The tone mapper shows 2.1188723 as 0.85.
    EXPECT_NEAR(result.start, std::log2(2.1188723 / 4), 1e-6);
    EXPECT_NEAR(result.stop, std::log2(2.1188723 / 0.25), 1e-6);
    EXPECT_EQ(result.exposures, 4);
}

TEST(Flip, OfLightIsThatOfTheToneMappedColours) {
    const HdrFlipResult result = hdr(Image<Rgb>({3, 2}, Rgb(1)), Image<Rgb>({3, 2}, Rgb(2)));
    EXPECT_NEAR(result.flip.mean, 0.1447528, of_flat_colours);
    EXPECT_EQ(result.exposures, 2);
}

TEST(Flip, OfLightDoesNotChangeWithItsUnit) {
    const Image<Rgb> a = bright(pattern({24, 17})), b = bright(altered_pattern({24, 17}));
    EXPECT_NEAR(hdr(a, b).flip.mean, hdr(scaled(a, 256), scaled(b, 256)).flip.mean, 1e-6);
}

TEST(Flip, SaysAtWhichExposureAnErrorIsLargest) {
    Image<Rgb> light({80, 1}, Rgb(0.01f));
    for (int x = 50; x < 80; ++x) light(x, 0) = Rgb(100);
    Image<Rgb> image = light;
    image(10, 0) *= 2.0f;
    image(70, 0) *= 2.0f;
    const HdrFlipResult result = hdr(light, image);
    EXPECT_GT(result.exposure(10, 0), result.exposure(70, 0) + 5);
}

TEST(Flip, OfExtremeLightIsANumber) {
    const Image<Rgb> black({3, 3}), huge({3, 3}, Rgb(3e38f)), negative({3, 3}, Rgb(-1));
    for (const Image<Rgb>& reference : {black, huge, negative}) {
        for (const Image<Rgb>& image : {black, huge, negative}) {
            const double mean = hdr(reference, image).flip.mean;
            EXPECT_TRUE(mean >= 0 && mean <= 1) << mean;
        }
    }
}

TEST(Flip, RefusesPicturesOfDifferentSizes) {
    EXPECT_THAT(
        [] {
            ldr(Image<Rgb>({2, 3}), Image<Rgb>({3, 2}));
        },
        ::testing::ThrowsMessage<Error>(::testing::HasSubstr("2x3")));
    EXPECT_THROW(hdr(Image<Rgb>({2, 3}), Image<Rgb>({3, 2})), Error);
}

TEST(FlipKernels, HaveTheReachAndTheSumsOfThePaper) {
    const flip::Kernels kernels(flip_pixels_per_degree);
    EXPECT_EQ(kernels.contrast_radius, 10);  // 3·√(0.04/2)/π·67.02 = 9.05
    EXPECT_EQ(kernels.feature_radius, 9);    // 3·0.041·67.02 = 8.24
    const auto sum = [](const flip::Kernels::Weights& weights) {
        return std::accumulate(weights.begin(), weights.end(), 0.0);
    };
    const auto positive = [](const flip::Kernels::Weights& weights) {
        double total = 0;
        for (const float weight : weights) total += std::max(weight, 0.0f);
        return total;
    };
    EXPECT_NEAR(sum(kernels.achromatic), 1, 1e-6);
    EXPECT_NEAR(std::hypot(sum(kernels.blue_yellow), sum(kernels.blue_yellow_narrow)), 1, 1e-6);
    for (const auto& weights : {kernels.edge, kernels.point}) {
        EXPECT_NEAR(positive(weights), 1, 1e-6);
        EXPECT_NEAR(sum(weights), 0, 1e-6);
    }
}

}  // namespace
}  // namespace luch
