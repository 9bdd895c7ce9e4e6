#include "framework/grading/gates.h"

#include "framework/base/error.h"
#include "framework/image/planes.h"
#include "tests/testing/own_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace luch::grading {
namespace {

constexpr Size size{100, 80};  // 0.05 % of it: 4 pixels

/// 1 in the left half, 2 in the right.
Image<std::uint32_t> halves() {
    Image<std::uint32_t> ids(size, 1);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 50; x < size.width; ++x) ids(x, y) = 2;
    }
    return ids;
}

TEST(IdGate, LetsAFewPixelsAlongEdgesPass) {
    Image<std::uint32_t> yours = halves();
    for (int y = 0; y < 4; ++y) yours(50, 10 * y) = 1;
    EXPECT_TRUE(same_ids(yours.view(), halves().view()).passed);
    yours(50, 79) = 1;
    const Finding finding = same_ids(yours.view(), halves().view());
    EXPECT_FALSE(finding.passed);
    EXPECT_EQ(finding.what, "5 of 8000 pixels have the wrong id, all within 1 px of an edge");
    EXPECT_EQ(finding.first, "(50,0) expected 2, got 1");
    EXPECT_EQ(finding.pixel, "50,0");
}

TEST(IdGate, LetsNoPixelAwayFromEdgesPass) {
    Image<std::uint32_t> yours = halves();
    yours(51, 7) = 1;
    EXPECT_FALSE(same_ids(yours.view(), halves().view()).passed);
}

Finding depths_with(float error, int count, int x) {
    const Image<float> reference(size, 10);
    Image<float> yours = reference;
    for (int i = 0; i < count; ++i) yours(x, i % size.height) += 10 * error;
    const Image<std::uint32_t> ids = halves();
    return same_depths(yours.view(), reference.view(), ids.view(), ids.view());
}

TEST(DepthGate, HoldsThePercentileAndTheLargestOffTheEdges) {
    EXPECT_TRUE(depths_with(5e-4f, 79, 20).passed) << "less than 1 % of the pixels";
    EXPECT_TRUE(depths_with(5e-3f, 79, 50).passed) << "on the edge";
    EXPECT_FALSE(depths_with(5e-3f, 1, 20).passed) << "off it";
    Image<float> yours(size, 10 * (1 + 2e-4f));
    const Image<float> reference(size, 10);
    const Image<std::uint32_t> ids = halves();
    EXPECT_FALSE(same_depths(yours.view(), reference.view(), ids.view(), ids.view()).passed);
}

TEST(DepthGate, TakesNoNumberThatIsNone) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(depths_with(nan, 1, 20).passed);
    EXPECT_FALSE(depths_with(-2, 1, 20).passed);
}

TEST(NumberGate, CountsElementsAndNotTheirNumbers) {
    const std::vector<double> reference{1, 2, 3, 4};
    EXPECT_TRUE(same_numbers(std::vector<double>{1, 2.0001, 3, 4}, reference, 1e-3, "x", 2).passed);
    const std::vector<double> wrong{1, 2, 5, 6};
    const Finding finding = same_numbers(wrong, reference, 1e-3, "the x of corner", 2);
    EXPECT_EQ(finding.what, "1 of 2: the x of corner is wrong");
    EXPECT_EQ(finding.first, "the x of corner 1 expected 3, got 5");
    EXPECT_FALSE(same_numbers(std::vector<double>{1}, reference, 1, "x").passed);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(same_numbers(std::vector<double>{nan, 2, 3, 4}, reference, 1, "x").passed);
}

TEST(Signatures, TellMistakesOfOnePlaceApart) {
    const auto moved = [](double by) {
        const std::vector<double> reference{1, 2}, yours{1 + by, 2 + by};
        return same_numbers(yours, reference, 1e-3, "x").signature;
    };
    EXPECT_EQ(moved(0.5), moved(0.51));
    EXPECT_NE(moved(0.5), moved(-0.5));
    EXPECT_NE(moved(0.5), moved(5));
}

TEST(Planes, KeepEveryBit) {
    const auto folder = own_folder();
    Image<std::uint32_t> ids = halves();
    ids(3, 4) = 0xffff'ffff;
    ids(4, 4) = 0x0100'0001;
    write_plane(folder / "ids.exr", ids.view());
    EXPECT_EQ(read_id_plane(folder / "ids.exr"), ids);
    Image<float> floats(size, 1.0f / 3);
    floats(1, 1) = std::numeric_limits<float>::infinity();
    write_plane(folder / "floats.exr", floats.view());
    EXPECT_EQ(read_float_plane(folder / "floats.exr"), floats);
    EXPECT_THROW(read_float_plane(folder / "ids.exr"), Error);
    EXPECT_THROW(read_id_plane(folder / "none.exr"), Error);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace luch::grading
