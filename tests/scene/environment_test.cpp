#include "framework/scene/environment.h"

#include <gtest/gtest.h>

#include <limits>

namespace luch {
namespace {

using Side = CubemapEnvironment::Side;

/// 3 × 3 sides; red is the side, green the column, blue the row.
CubemapEnvironment labelled() {
    CubemapEnvironment environment;
    for (int side = 0; side < 6; ++side) {
        environment.sides[side] = Image<Rgb>({3, 3});
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < 3; ++x) environment.sides[side](x, y) = Rgb(side, x, y);
        }
    }
    return environment;
}

// Each row: a direction to the centre of a side's pixel (2, 0), the top right one, at s = 1 and
// t = −1, from the table in the format's description, for example −x (z, −y): z = 1, y = 1.
TEST(Cubemap, HasItsSidesAsTheCourseLaysThemOut) {
    const CubemapEnvironment environment = labelled();
    const double in = 1 - 1e-9;  // just inside the side, off its edges
    const struct {
        Side side;
        Vec3d direction;
    } top_right[] = {
        {Side::neg_x, {-1, in, in}}, {Side::neg_y, {in, -1, in}}, {Side::neg_z, {in, -in, -1}},
        {Side::pos_x, {1, in, -in}}, {Side::pos_y, {in, 1, -in}}, {Side::pos_z, {in, in, 1}},
    };
    for (const auto& [side, direction] : top_right) {
        const Rgb found = environment.radiance(direction);
        EXPECT_EQ(found.r, static_cast<float>(side));
        EXPECT_NEAR(found.g, 2, 1e-6) << side;
        EXPECT_NEAR(found.b, 0, 1e-6) << side;
    }
}

TEST(Cubemap, IsBilinearBetweenPixelCentres) {
    // −z (x, y): s = 0.5 is column (0.5 + 1)/2·2 = 1.5, t = −0.25 is row 0.75.
    const Rgb found = labelled().radiance({0.5, -0.25, -1});
    EXPECT_EQ(found.r, static_cast<float>(Side::neg_z));
    EXPECT_FLOAT_EQ(found.g, 1.5f);
    EXPECT_FLOAT_EQ(found.b, 0.75f);
}

TEST(Cubemap, DoesNotCareForTheLengthOfADirection) {
    const CubemapEnvironment environment = labelled();
    for (const double length : {1e-300, 0.1, 1e300}) {
        EXPECT_EQ(environment.radiance(Vec3d(0.5, -0.25, -1) * length),
                  environment.radiance({0.5, -0.25, -1}));
    }
}

TEST(Cubemap, AnswersAtItsEdgesAndCorners) {
    const CubemapEnvironment environment = labelled();
    for (int i = 0; i < 27; ++i) {
        const Vec3d direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (direction == Vec3d(0)) continue;
        const Rgb found = environment.radiance(direction);
        EXPECT_EQ(found.r, std::floor(found.r)) << "a mixture of sides";
        EXPECT_TRUE(found.g >= 0 && found.g <= 2 && found.b >= 0 && found.b <= 2);
    }
}

TEST(Cubemap, IsBlackWhereThereIsNoDirection) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const CubemapEnvironment environment = labelled();
    for (const Vec3d direction : {Vec3d(0), Vec3d(infinity, 0, 0), Vec3d(0, std::nan(""), 1)}) {
        EXPECT_EQ(environment.radiance(direction), Rgb(0));
    }
    EXPECT_EQ(CubemapEnvironment{}.radiance({1, 0, 0}), Rgb(0));
}

}  // namespace
}  // namespace luch
