#include "framework/scene/heightfield.h"

#include "framework/scene/geometry.h"

#include <gtest/gtest.h>

#include <numbers>

namespace luch {
namespace {

/// 3 × 2 pixels, all different.
Heightfield small_field() {
    Image<float> heights({3, 2});
    heights.pixels() = {0.5f, 0.25f, 1, 0, 0.75f, 0.125f};
    return Heightfield(heights);
}

TEST(Heightfield, GoesOnAsItWasPastTheLastPixel) {
    const Heightfield field = small_field();
    EXPECT_EQ(field.at(3, 0), 1);
    EXPECT_EQ(field.at(1, 2), 0.75f);
    EXPECT_EQ(field.at(3, 2), 0.125f);
    const Boxd box = bounds_of(field);
    EXPECT_EQ(box.lo, Vec3d(0, 0, 0));
    EXPECT_EQ(box.hi, Vec3d(3, 1, 2));
}

TEST(Heightfield, HasNormalsFromForwardDifferencesAndCopiesAtTheEnd) {
    const Heightfield field = small_field();
    EXPECT_EQ(field.normal(0, 0), glm::normalize(Vec3d(0.25, 1, 0.5)));
    EXPECT_EQ(field.normal(1, 0), glm::normalize(Vec3d(-0.75, 1, -0.5)));
    EXPECT_EQ(field.normal(2, 0), field.normal(1, 0));
    EXPECT_EQ(field.normal(3, 2), field.normal(1, 0));
    EXPECT_EQ(field.normal(0, 1), field.normal(0, 0));
    Image<float> one({1, 1}, 0.5f);
    EXPECT_EQ(Heightfield(one).normal(0, 0), Vec3d(0, 1, 0));
}

TEST(Heightfield, NumbersItsTriangles) {
    const Heightfield field = small_field();
    EXPECT_EQ(primitive_count(field), 12u);
    std::uint32_t expected = 0;
    for (int z = 0; z < 2; ++z) {
        for (int x = 0; x < 3; ++x) {
            for (int k = 0; k < 2; ++k, ++expected) {
                EXPECT_EQ(field.primitive(x, z, k), expected);
                const auto triangle = field.triangle(expected);
                EXPECT_EQ(triangle.x, x);
                EXPECT_EQ(triangle.z, z);
                EXPECT_EQ(triangle.k, k);
            }
        }
    }
}

TEST(Heightfield, KnowsTheRangeOfEveryBlock) {
    Image<float> heights({37, 21});
    for (int i = 0; i < 37 * 21; ++i) {
        heights.pixels()[static_cast<std::size_t>(i)] = static_cast<float>(i * 7919 % 1009);
    }
    const Heightfield field(heights);
    for (int level = 0; level <= field.top_level(); ++level) {
        for (int z = 0; z < 21; z += 3) {
            for (int x = 0; x < 37; x += 5) {
                const int x0 = x >> level << level, z0 = z >> level << level;
                float lo = 1e9f, hi = -1;
                for (int j = z0; j <= std::min(z0 + (1 << level), 21); ++j) {
                    for (int i = x0; i <= std::min(x0 + (1 << level), 37); ++i) {
                        lo = std::min(lo, field.at(i, j));
                        hi = std::max(hi, field.at(i, j));
                    }
                }
                EXPECT_EQ(field.range(level, x, z).lo, lo) << level << ' ' << x << ' ' << z;
                EXPECT_EQ(field.range(level, x, z).hi, hi) << level << ' ' << x << ' ' << z;
            }
        }
    }
    EXPECT_EQ(field.top_level(), 6);
}

/// The same by the formula, pixel by pixel.
double blurred_at(const Image<float>& heights, double sigma, int x, int y) {
    const int radius = static_cast<int>(std::min(std::round(3 * sigma), 128.0));
    double sum = 0;
    for (int j = 1 - radius; j < radius; ++j) {
        for (int i = 1 - radius; i < radius; ++i) {
            if (x + i < 0 || x + i >= heights.width() || y + j < 0 || y + j >= heights.height()) {
                continue;
            }
            sum += heights(x + i, y + j) * std::exp(-(i * i + j * j) / (2 * sigma * sigma)) /
                   (2 * std::numbers::pi * sigma * sigma);
        }
    }
    return sum;
}

TEST(Blur, IsTheGaussianOfTheCourseWithSinkingEdges) {
    Image<float> heights({23, 9});
    for (int i = 0; i < 23 * 9; ++i) {
        heights.pixels()[static_cast<std::size_t>(i)] = static_cast<float>(i * 31 % 17) / 17;
    }
    for (const double sigma : {0.4, 1.0, 2.5, 60.0}) {
        const Image<float> result = blurred(heights, sigma);
        ASSERT_EQ(result.size(), heights.size());
        for (int y = 0; y < 9; ++y) {
            for (int x = 0; x < 23; ++x) {
                ASSERT_NEAR(result(x, y), blurred_at(heights, sigma, x, y), 1e-6) << sigma;
            }
        }
    }
    const Image<float> flat = blurred(Image<float>({40, 40}, 1), 2);
    EXPECT_NEAR(flat(0, 0), flat(20, 20) / 4, 0.13);  // three quarters of the weights are outside
    EXPECT_LT(flat(20, 20), 1);
}

TEST(Blur, ChangesNothingWhereItsRadiusRoundsToNone) {
    Image<float> heights({3, 1});
    heights.pixels() = {1, 0.5f, 0};
    EXPECT_EQ(blurred(heights, 0), heights);
    EXPECT_EQ(blurred(heights, 1e-6), heights);
}

}  // namespace
}  // namespace luch
