#include "framework/math/colour.h"

#include <gtest/gtest.h>

#include <limits>

namespace luch {
namespace {

TEST(Srgb, HasTheStandardsValues) {
    // IEC 61966-2-1: the line up to 0.0031308, the power above; 0.5 worked out by hand.
    EXPECT_FLOAT_EQ(srgb_encoded(0.001f), 0.01292f);
    EXPECT_NEAR(srgb_encoded(0.5f), 0.7353570f, 1e-6);
    EXPECT_NEAR(srgb_encoded(0.0031308f), 0.0404499f, 1e-6);
    EXPECT_NEAR(srgb_decoded(0.5f), 0.2140411f, 1e-6);
    EXPECT_FLOAT_EQ(srgb_encoded(1.0f), 1.0f);
}

TEST(Srgb, DecodesWhatItEncodedForEveryByte) {
    for (int byte = 0; byte < 256; ++byte) {
        const float encoded = static_cast<float>(byte) / 255;
        EXPECT_EQ(byte_of(srgb_encoded(srgb_decoded(encoded))), byte);
    }
}

TEST(Srgb, ClampsWhatADisplayCannotShow) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(srgb_encoded(-1.0f), 0);
    EXPECT_EQ(srgb_encoded(7.0f), 1);
    EXPECT_EQ(srgb_encoded(infinity), 1);
    EXPECT_EQ(srgb_encoded(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(ByteOf, RoundsToNearest) {
    EXPECT_EQ(byte_of(0.49f / 255), 0);
    EXPECT_EQ(byte_of(std::numeric_limits<float>::quiet_NaN()), 0);
    EXPECT_EQ(byte_of(-std::numeric_limits<float>::infinity()), 0);
    EXPECT_EQ(byte_of(std::numeric_limits<float>::infinity()), 255);
    EXPECT_EQ(byte_of(0.51f / 255), 1);
    EXPECT_EQ(byte_of(254.49f / 255), 254);
    EXPECT_EQ(byte_of(254.51f / 255), 255);
    EXPECT_EQ(byte_of(2), 255);
    EXPECT_EQ(byte_of(-2), 0);
}

}  // namespace
}  // namespace luch
