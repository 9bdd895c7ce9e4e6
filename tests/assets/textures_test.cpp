#include "scenes/generator/textures.h"

#include "scenes/generator/noise.h"
#include "scenes/generator/sky.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luch::assets {
namespace {

int at(const IndexedImage& image, int x, int y) {
    return image.pixels[y * image.size.width + x];
}

/// The mean step from column x to the next, the picture going round.
double step_after(const IndexedImage& image, int x) {
    const int next = (x + 1) % image.size.width;
    double sum = 0;
    for (int y = 0; y < image.size.height; ++y) {
        sum += std::abs(at(image, x, y) - at(image, next, y));
    }
    return sum / image.size.height;
}

IndexedImage turned(IndexedImage image) {
    IndexedImage result = image;
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) {
            result.pixels[x * image.size.height + y] = image.pixels[y * image.size.width + x];
        }
    }
    return result;
}

void expect_no_seam(const IndexedImage& image) {
    double mean = 0;
    for (int x = 0; x < image.size.width; ++x) mean += step_after(image, x) / image.size.width;
    EXPECT_GT(mean, 0);
    EXPECT_LT(step_after(image, image.size.width - 1), 2 * mean);
}

TEST(Textures, TileWithoutASeam) {
    for (const IndexedImage& image :
         {marble({256, 256}), plaster({256, 256}), hammered({128, 128})}) {
        expect_no_seam(image);
        expect_no_seam(turned(image));
    }
    // Between two rows of boards there is a joint.
    expect_no_seam(boards({256, 256}));
}

TEST(Noise, RepeatsAfterOneInBothDirections) {
    const Noise noise(3);
    for (const double x : {0.0, 0.13, 0.5, 0.99}) {
        EXPECT_NEAR(noise.fractal(x, 0.3, 3, 5, 4), noise.fractal(x + 1, 0.3, 3, 5, 4), 1e-9);
        EXPECT_NEAR(noise.fractal(0.3, x, 3, 5, 4), noise.fractal(0.3, x - 1, 3, 5, 4), 1e-9);
        EXPECT_NE(noise.at(x, 0.3, 3, 5), Noise(4).at(x, 0.3, 3, 5));
    }
}

TEST(Ramp, StartsAndEndsWithItsStopsAndRoundsBetween) {
    constexpr Byte3 stops[] = {{0, 100, 255}, {255, 0, 0}};
    const auto colours = ramp(stops);
    EXPECT_EQ(colours[0].blue, 255);
    EXPECT_EQ(colours[255].red, 255);
    EXPECT_EQ(colours[7].red, 7);
    EXPECT_EQ(colours[7].green, 97);   // 97.25
    EXPECT_EQ(colours[1].green, 100);  // 99.61
}

TEST(Bmp, HasTheHeaderAndThePaddingOfTheFormat) {
    constexpr Byte3 stops[] = {{1, 2, 3}, {4, 5, 6}};
    const IndexedImage image{{3, 2}, ramp(stops), {10, 11, 12, 20, 21, 22}};
    const std::string bytes = bmp_bytes(image);
    EXPECT_EQ(bytes.size(), 14u + 40 + 1024 + 8);
    EXPECT_EQ(bytes.substr(0, 2), "BM");
    EXPECT_EQ(static_cast<unsigned char>(bytes[2]) | static_cast<unsigned char>(bytes[3]) << 8,
              1086);
    EXPECT_EQ(bytes.substr(54, 4), std::string("\3\2\1\0", 4));
    EXPECT_EQ(bytes.substr(1078), std::string("\24\25\26\0\12\13\14\0", 8));
}

TEST(Sky, MeetsAtTheEdgesOfTheCube) {
    const auto sky = evening_sky(16);
    ASSERT_EQ(sky.size(), 6u);
    const auto& negx = sky[0].second;
    const auto& posx = sky[3].second;
    const auto& posy = sky[4].second;
    const auto& posz = sky[5].second;
    for (int k = 0; k < 16; ++k) {
        EXPECT_EQ(at(negx, 15, k), at(posz, 0, k));  // z = 1, x = −1
        EXPECT_EQ(at(posx, 0, k), at(posz, 15, k));  // z = 1, x = 1
        EXPECT_EQ(at(posy, k, 15), at(posz, k, 0));  // y = 1, z = 1
        EXPECT_EQ(at(negx, k, 0), at(posy, 0, k));   // x = −1, y = 1
    }
    EXPECT_NE(at(posz, 8, 0), at(posz, 8, 15));
}

}  // namespace
}  // namespace luch::assets
