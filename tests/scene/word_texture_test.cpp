#include "framework/scene/word_texture.h"

#include <gtest/gtest.h>

#include <limits>

namespace luch {
namespace {

/// A picture of 8 bits a channel, as a file is read.
BitmapTexture of_eight_bits() {
    BitmapTexture bitmap{Image<Rgb>({16, 16}), 3, 0.5};
    for (std::size_t i = 0; i < 256; ++i) {
        const auto level = static_cast<float>(i);
        bitmap.pixels.pixels()[i] = srgb_decoded(Rgb(level, 255 - level, 77) / 255.0f);
    }
    return bitmap;
}

TEST(WordTexture, IsTheBitmapToTheLastBit) {
    const BitmapTexture bitmap = of_eight_bits();
    const auto words = WordTexture::of(bitmap);
    ASSERT_TRUE(words);
    EXPECT_EQ(words->bytes(), 16u * 16 * 4);
    EXPECT_EQ(words->texels()(1, 0), 0xff01fe4du);
    for (int i = -40; i < 40; ++i) {
        for (int j = -40; j < 40; ++j) {
            const Vec2d uv(0.173 * i, 0.119 * j);
            ASSERT_EQ(words->colour_at(uv), colour_at(bitmap, {uv})) << i << ' ' << j;
        }
    }
}

TEST(WordTexture, IsThereOnlyWhereNoTexelLosesAnything) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float wild : {0.5f, 1.5f, -0.1f, nan}) {
        BitmapTexture bitmap = of_eight_bits();
        bitmap.pixels(3, 4).g = wild;
        EXPECT_FALSE(WordTexture::of(bitmap)) << wild;
    }
    const WordTextures all = word_textures({CheckerTexture{}, of_eight_bits(), Fresnel{}});
    ASSERT_EQ(all.size(), 3u);
    EXPECT_FALSE(all[0] || all[2]);
    EXPECT_TRUE(all[1]);
}

TEST(WordTexture, IsBlackWithoutAnyTexel) {
    const auto words = WordTexture::of(BitmapTexture{});
    ASSERT_TRUE(words);
    EXPECT_EQ(words->colour_at({0.3, 0.7}), Rgb(0));
}

}  // namespace
}  // namespace luch
