#include "framework/measure/ssim.h"

#include "framework/base/error.h"
#include "tests/measure/patterns.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace luch {
namespace {

using testing::altered_pattern;
using testing::pattern;
using testing::transposed;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

SsimResult of(const Image<Rgb>& reference, const Image<Rgb>& image) {
    return ssim(reference.view(), image.view(), Workers(1));
}

/// skimage.metrics.structural_similarity(a, b, gaussian_weights=True, sigma=1.5,
/// use_sample_covariance=False, data_range=1.0, channel_axis=2) of scikit-image 0.19.3.
TEST(Ssim, IsThatOfScikitImage) {
    EXPECT_NEAR(of(pattern({24, 17}), altered_pattern({24, 17})).mean, 0.8004297348, 1e-8);
}

/// From the definition, with scipy.ndimage.gaussian_filter of SciPy 1.10.1, mode "reflect".
TEST(Ssim, CountsEveryRowWhereNoWindowFits) {
    EXPECT_NEAR(of(pattern({24, 7}), altered_pattern({24, 7})).mean, 0.7757376084, 1e-8);
}

TEST(Ssim, OfEqualPicturesIsOne) {
    const SsimResult result = of(pattern({24, 17}), pattern({24, 17}));
    EXPECT_NEAR(result.mean, 1, 1e-12);
    for (const float value : result.map.pixels()) EXPECT_NEAR(value, 1, 1e-6);
}

/// Without variance only the means remain: (2rv + c1)/(r² + v² + c1), c1 = 0.0001.
TEST(Ssim, OfTwoColoursComparesTheirMeans) {
    for (const Size size : {Size{1, 1}, Size{1, 30}, Size{20, 20}}) {
        const double mean = of(Image<Rgb>(size, Rgb(0.25f)), Image<Rgb>(size, Rgb(0.75f))).mean;
        EXPECT_NEAR(mean, 0.3751 / 0.6251, 1e-6);
    }
}

TEST(Ssim, OfAnInvertedPictureIsNegative) {
    Image<Rgb> image = pattern({24, 17});
    for (Rgb& pixel : image.pixels()) pixel = Rgb(1) - pixel;
    EXPECT_LT(of(pattern({24, 17}), image).mean, -0.5);
}

TEST(Ssim, IsSymmetricAndTreatsBothAxesAlike) {
    const Image<Rgb> a = pattern({30, 13}), b = altered_pattern({30, 13});
    const double mean = of(a, b).mean;
    EXPECT_NEAR(of(b, a).mean, mean, 1e-12);
    EXPECT_NEAR(of(transposed(a), transposed(b)).mean, mean, 1e-7);
}

/// Rows are worked on in bands of 64; a picture of several must not show them.
TEST(Ssim, IsTheSameOnAnyNumberOfWorkersAndInAnyBand) {
    const Image<Rgb> a = pattern({20, 150}), b = altered_pattern({20, 150});
    const Image<float> alone = of(a, b).map;
    EXPECT_EQ(ssim(a.view(), b.view(), Workers(3)).map, alone);
    Image<Rgb> lower_a({20, 100}), lower_b({20, 100});
    std::copy(a.pixels().begin() + 20 * 50, a.pixels().end(), lower_a.pixels().begin());
    std::copy(b.pixels().begin() + 20 * 50, b.pixels().end(), lower_b.pixels().begin());
    const Image<float> lower = of(lower_a, lower_b).map;
    for (int y = 5; y < 100; ++y) EXPECT_EQ(lower(7, y), alone(7, y + 50)) << y;
}

TEST(Ssim, OfAPixelThatIsNotFiniteIsNaNAndItsNeighboursDoNotSeeIt) {
    Image<Rgb> broken = pattern({24, 17});
    broken(10, 8) = Rgb(0, nan, 0);
    const SsimResult result = of(pattern({24, 17}), broken);
    EXPECT_NEAR(result.mean, 1, 1e-7);
    EXPECT_TRUE(std::isnan(result.map(10, 8)));
    EXPECT_NEAR(result.map(11, 8), 1, 1e-6);
    EXPECT_TRUE(std::isnan(of(Image<Rgb>({2, 2}, Rgb(nan)), Image<Rgb>({2, 2})).mean));
}

TEST(Ssim, RefusesPicturesOfDifferentSizes) {
    EXPECT_THROW(of(Image<Rgb>({2, 3}), Image<Rgb>({3, 2})), Error);
}

}  // namespace
}  // namespace luch
