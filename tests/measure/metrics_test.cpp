#include "framework/measure/metrics.h"

#include "framework/base/error.h"

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
    EXPECT_DOUBLE_EQ(errors.max_error, 0.5);
    EXPECT_DOUBLE_EQ(errors.p999, 0.5);
    EXPECT_EQ(errors.max_at.x, 1);
    EXPECT_EQ(errors.max_at.y, 0);
    EXPECT_EQ(errors.differing, 1u);
}

TEST(Metrics, OfEqualImagesAreZeroAndThePsnrIsInfinite) {
    const Image<Rgb> image({3, 2}, Rgb(0.3f));
    const Errors errors = errors_of(image, image);
    EXPECT_EQ(errors.rmse, 0);
    EXPECT_EQ(errors.relmse, 0);
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
        EXPECT_EQ(errors.differing, 0u);
    }
}

TEST(Metrics, AreNoNumbersWhenNoPixelIsFinite) {
    const Image<Rgb> image({2, 2}, Rgb(nan));
    EXPECT_TRUE(std::isnan(errors_of(image, image).rmse));
    EXPECT_TRUE(std::isnan(errors_of(image, image).psnr));
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
    EXPECT_THAT([] { find_metric("rsme"); },
                ::testing::ThrowsMessage<Error>(::testing::HasSubstr("rmse")));
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
