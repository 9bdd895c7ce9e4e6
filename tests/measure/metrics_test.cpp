#include "framework/measure/metrics.h"

#include "framework/base/error.h"
#include "tests/measure/patterns.h"

#include <gmock/gmock.h>

#include <cmath>

namespace luch {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

Errors errors_of(const Image<Rgb>& a, const Image<Rgb>& b) {
    return errors_between(a.view(), b.view());
}

TEST(Metrics, AgreeWithValuesComputedByHand) {
    const Image<Rgb> reference({2, 1}, Rgb(0.25f));
    Image<Rgb> image = reference;
    image(1, 0) += Rgb(0.5f, -0.125f, 0);
    const Errors errors = errors_of(reference, image);
    const double squares = 0.25 + 0.015625;
    EXPECT_DOUBLE_EQ(errors.rmse, std::sqrt(squares / 6));
    EXPECT_DOUBLE_EQ(errors.relmse, squares / (0.26 * 0.26) / 6);
    EXPECT_DOUBLE_EQ(errors.psnr, 20 * std::log10(1 / std::sqrt(squares / 6)));
    EXPECT_DOUBLE_EQ(errors.mae, 0.625 / 6);
    EXPECT_DOUBLE_EQ(errors.max_error, 0.5);
    EXPECT_DOUBLE_EQ(errors.p999, 0.5);
    EXPECT_EQ(errors.max_at.x, 1);
    EXPECT_EQ(errors.max_at.y, 0);
    EXPECT_EQ(errors.differing, 1u);
}

/// NumPy 1.24.2 and scikit-image 0.19.3, from the formulas; FLIP as flip_test.cpp has it.
TEST(Metrics, OfAPatternAreWhatTheFormulasGiveElsewhere) {
    const Image<Rgb> a = testing::pattern({24, 17}), b = testing::altered_pattern({24, 17});
    const Errors errors = errors_between(a.view(), b.view(), {Encoding::srgb, Gaze{{4, 12}}});
    EXPECT_NEAR(errors.rmse, 0.216261344778, 1e-8);
    EXPECT_NEAR(errors.relmse, 10.066437123857, 1e-6);
    EXPECT_NEAR(errors.psnr, 13.300422015258, 1e-7);
    EXPECT_NEAR(errors.mae, 0.112960727216, 1e-9);
    EXPECT_NEAR(errors.ssim, 0.800429734761, 1e-8);
    EXPECT_NEAR(errors.flip, 0.622054438, 1e-6);
    EXPECT_NEAR(errors.foveal_rmse, 0.218014280, 1e-8);
}

TEST(Metrics, HoldTheFlipThatFitsTheEncoding) {
    const Image<Rgb> one({3, 2}, Rgb(1)), two({3, 2}, Rgb(2));
    const Errors shown = errors_between(one.view(), two.view(), {.encoding = Encoding::srgb});
    EXPECT_EQ(shown.flip, 0);
    EXPECT_EQ(shown.encoding, Encoding::srgb);
    const Errors light = errors_between(one.view(), two.view(), {.encoding = Encoding::linear});
    EXPECT_NEAR(light.flip, 0.1447528, 1e-4);
    EXPECT_EQ(light.encoding, Encoding::linear);
}

TEST(Metrics, CountMisclassifiedPixelsOfBlackAndWhitePicturesOnly) {
    Image<Rgb> reference({4, 1}), image({4, 1});
    reference(0, 0) = reference(1, 0) = image(1, 0) = Rgb(1);
    EXPECT_DOUBLE_EQ(errors_of(reference, image).misclassified, 0.25);
    EXPECT_DOUBLE_EQ(errors_of(image, reference).misclassified, 0.25);
    image(2, 0) = Rgb(nan);
    EXPECT_DOUBLE_EQ(errors_of(reference, image).misclassified, 1.0 / 3);
    image(3, 0) = Rgb(0, 0, 1);
    EXPECT_TRUE(std::isnan(errors_of(reference, image).misclassified));
}

TEST(Metrics, OfEqualImagesAreZeroAndThePsnrIsInfinite) {
    const Image<Rgb> image({3, 2}, Rgb(0.3f));
    const Errors errors = errors_of(image, image);
    EXPECT_EQ(errors.rmse, 0);
    EXPECT_EQ(errors.relmse, 0);
    EXPECT_EQ(errors.mae, 0);
    EXPECT_EQ(errors.flip, 0);
    EXPECT_NEAR(errors.ssim, 1, 1e-12);
    EXPECT_EQ(errors.max_error, 0);
    EXPECT_EQ(errors.differing, 0u);
    EXPECT_TRUE(std::isinf(errors.psnr) && errors.psnr > 0);
    EXPECT_EQ(errors.max_at.x, -1);
}

TEST(Metrics, The999thPercentileLeavesOutOnePixelInAThousandAndNoMore) {
    const Image<Rgb> reference({100, 20});
    Image<Rgb> image = reference;
    for (int x = 0; x < 3; ++x) image(x, 0) = Rgb(static_cast<float>(3 - x) * 0.25f);
    EXPECT_DOUBLE_EQ(errors_of(reference, image).p999, 0.25);
    image(2, 0) = Rgb(0);
    EXPECT_DOUBLE_EQ(errors_of(reference, image).p999, 0);
}

TEST(Metrics, CountPixelsThatAreNotFiniteApartAndFindTheFirst) {
    const Image<Rgb> reference({4, 4}, Rgb(0.5f));
    Image<Rgb> image = reference;
    image(2, 1) = Rgb(0, nan, 0);
    image(0, 3) = Rgb(infinity, 0, 0);
    for (const Errors& errors : {errors_of(reference, image), errors_of(image, reference)}) {
        EXPECT_EQ(errors.non_finite.count, 2u);
        EXPECT_EQ(errors.non_finite.first_x, 2);
        EXPECT_EQ(errors.non_finite.first_y, 1);
        EXPECT_EQ(errors.rmse, 0);
        EXPECT_EQ(errors.mae, 0);
        EXPECT_EQ(errors.flip, 0);
        EXPECT_NEAR(errors.ssim, 1, 1e-12);
        EXPECT_EQ(errors.differing, 0u);
    }
}

TEST(Metrics, AreNoNumbersWhenNoPixelIsFinite) {
    const Image<Rgb> image({2, 2}, Rgb(nan));
    for (const Metric& metric : metrics()) {
        EXPECT_TRUE(std::isnan(errors_of(image, image).*metric.value)) << metric.name;
    }
}

TEST(Metrics, RefuseImagesOfDifferentSizesAndNameBoth) {
    const Image<Rgb> a({2, 3}), b({3, 2});
    EXPECT_THAT([&] { errors_of(a, b); },
                ::testing::ThrowsMessage<Error>(
                    ::testing::AllOf(::testing::HasSubstr("2x3"), ::testing::HasSubstr("3x2"))));
    EXPECT_THROW(errors_of({}, {}), Error);
}

TEST(Metrics, AreFoundByNameAndTheNearestIsOfferedForAMistake) {
    EXPECT_EQ(find_metric("psnr").label, "PSNR");
    EXPECT_EQ(find_metric("misclassified").value, &Errors::misclassified);
    EXPECT_THAT([] { find_metric("rsme"); },
                ::testing::ThrowsMessage<Error>(::testing::HasSubstr("rmse")));
}

TEST(Metrics, AreShownWithTheirUnits) {
    Errors errors;
    EXPECT_EQ(shown(find_metric("psnr"), errors), "∞");
    errors.psnr = 41.204;
    errors.ssim = 0.99731;
    errors.flip = 0.012345;
    EXPECT_EQ(shown(find_metric("psnr"), errors), "41.20 dB");
    EXPECT_EQ(shown(find_metric("ssim"), errors), "0.99731");
    EXPECT_EQ(shown(find_metric("flip"), errors), "0.0123");
    EXPECT_EQ(shown(find_metric("misclassified"), errors), "NaN");
}

TEST(Displayed, EncodesAndClampsButHidesNothingThatIsNotFinite) {
    Image<Rgb> linear({3, 1}, Rgb(2));
    linear(1, 0) = Rgb(infinity, 0.5f, 0.5f);
    linear(2, 0) = Rgb(0.5f);
    const Image<Rgb> shown = displayed(linear.view());
    EXPECT_EQ(shown(0, 0), Rgb(1));
    EXPECT_TRUE(std::isnan(shown(1, 0).r));
    EXPECT_NEAR(shown(2, 0).g, 0.7354, 1e-4);
}

TEST(Comparable, IsLinearForLinearPicturesAndAsDisplayedOtherwise) {
    const Picture linear{Image<Rgb>({1, 1}, Rgb(0.5f)), Encoding::linear};
    const Picture encoded{Image<Rgb>({1, 1}, Rgb(0.5f)), Encoding::srgb};
    EXPECT_EQ(comparable(linear, linear).encoding, Encoding::linear);
    EXPECT_EQ(comparable(encoded, encoded).encoding, Encoding::srgb);
    const ComparablePair mixed = comparable(linear, encoded);
    EXPECT_EQ(mixed.encoding, Encoding::srgb);
    EXPECT_THAT(mixed.why, ::testing::HasSubstr("one of them is linear"));
    EXPECT_NEAR(mixed.reference(0, 0).r, 0.7354, 1e-4);
    EXPECT_EQ(mixed.image(0, 0).r, 0.5f);
    const ComparablePair asked = comparable(linear, encoded, Encoding::linear);
    EXPECT_EQ(asked.reference(0, 0).r, 0.5f);
    EXPECT_NEAR(asked.image(0, 0).r, 0.2140, 1e-4);
}

}  // namespace
}  // namespace luch
