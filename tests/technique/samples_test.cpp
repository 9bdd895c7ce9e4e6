#include "framework/technique/samples.h"

#include <gtest/gtest.h>

#include <set>

namespace luch {
namespace {

Shot lens_shot(int spp) {
    Shot shot{.camera = {}, .size = {8, 8}, .spp = spp};
    shot.camera.depth_of_field = true;
    shot.camera.lens_samples = 17;
    return shot;
}

TEST(SampleCount, IsGivenOrTheLenssOrOne) {
    EXPECT_EQ(sample_count(lens_shot(5)), 5);
    EXPECT_EQ(sample_count(lens_shot(0)), 17);
    Shot shot = lens_shot(0);
    shot.camera.projection = Projection::spherical;
    EXPECT_EQ(sample_count(shot), 1);
    shot.camera.depth_of_field = false;
    EXPECT_EQ(sample_count(shot), 1);
}

TEST(SamplePosition, IsTheCentreOfOneSample) {
    EXPECT_EQ(sample_position(lens_shot(1), 3, 4, 0, 1), Vec2d(3.5, 4.5));
}

TEST(SamplePosition, PutsFourSamplesIntoFourQuarters) {
    for (int y = 0; y < 8; ++y) {
        std::set<int> quarters;
        for (int i = 0; i < 4; ++i) {
            const Vec2d p = sample_position(lens_shot(4), 3, y, i, 4) - Vec2d(3, y);
            ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
            quarters.insert(int(2 * p.x) + 2 * int(2 * p.y));
        }
        EXPECT_EQ(quarters.size(), 4u);
    }
}

TEST(Samples, HaveNothingToDoWithOneAnother) {
    // Over many pixels: place and lens point of a sample, and either in neighbouring pixels.
    double place_and_lens = 0, neighbours = 0;
    Shot shot = lens_shot(4);
    shot.size = {64, 64};
    constexpr double uniform_variance = 1.0 / 12, disc_variance = 1.0 / 4;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 63; ++x) {
            const Vec2d place = sample_position(shot, x, y, 1, 4) - Vec2d(x, y) - 0.5;
            const Vec2d next = sample_position(shot, x + 1, y, 1, 4) - Vec2d(x + 1, y) - 0.5;
            place_and_lens += place.x * lens_point(shot, x, y, 1).x;
            neighbours += place.x * next.x;
        }
    }
    constexpr double count = 64 * 63, four_deviations = 4 / 63.0;
    EXPECT_NEAR(place_and_lens / count / std::sqrt(uniform_variance * disc_variance), 0,
                four_deviations);
    EXPECT_NEAR(neighbours / count / uniform_variance, 0, four_deviations);
}

TEST(PrimaryRay, LeavesTheEyeUnlessThereIsALens) {
    Shot shot = lens_shot(4);
    const Screen screen(shot.camera, shot.size);
    EXPECT_EQ(primary_ray(screen, shot, 3, 4, 2, 4, false).origin, screen.eye());
    EXPECT_NE(primary_ray(screen, shot, 3, 4, 2, 4, true).origin, screen.eye());
    shot.camera.depth_of_field = false;
    const Screen pinhole(shot.camera, shot.size);
    const Ray forced = primary_ray(pinhole, shot, 3, 4, 2, 4, true);
    EXPECT_EQ(forced.origin, screen.eye());
    EXPECT_EQ(forced.direction, primary_ray(pinhole, shot, 3, 4, 2, 4, false).direction);
}

}  // namespace
}  // namespace luch
