#include "scenes/generator/sixty_spheres.h"

#include "framework/scene/camera.h"
#include "framework/scene/loader/loader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace luch::assets {
namespace {

TEST(SixtySpheres, AreSixtyThatNeverTouch) {
    const auto balls = sixty_balls();
    ASSERT_EQ(balls.size(), 60u);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GT(glm::distance(balls[i].centre, balls[j].centre),
                      balls[i].radius + balls[j].radius);
        }
    }
}

TEST(SixtySpheres, LieOnTheFloorOrHangAboveIt) {
    const auto balls = sixty_balls();
    for (const Ball& ball : balls) EXPECT_GE(ball.centre.y, ball.radius);
    const auto lying = std::count_if(balls.begin(), balls.end(),
                                     [](const Ball& ball) { return ball.centre.y == ball.radius; });
    EXPECT_EQ(lying, 40);
}

TEST(SixtySpheres, DifferInSizeAndColour) {
    const auto balls = sixty_balls();
    EXPECT_GT(balls.front().radius, 3 * balls.back().radius);
    std::set<int> colours;
    for (const Ball& ball : balls) colours.insert(ball.colour);
    EXPECT_EQ(colours.size(), 8u);
}

bool sees(const Ray& ray, const Ball& ball) {
    const Vec3d to_centre = ball.centre - ray.origin;
    const double along = glm::dot(to_centre, ray.direction);
    const Vec3d miss = to_centre - along * ray.direction;
    return along > 0 && glm::dot(miss, miss) < ball.radius * ball.radius;
}

TEST(SixtySpheres, CoverThreeFifthsOfTheFrame) {
    const std::filesystem::path file = LUCH_SOURCE_DIR "/scenes/spheres/spheres.scene";
    const Scene scene = load_scene(file).scene;
    const auto balls = sixty_balls();
    const Screen screen(scene.camera, scene.settings.frame);
    int covered = 0;
    for (int y = 0; y < screen.size().height; ++y) {
        for (int x = 0; x < screen.size().width; ++x) {
            const Ray ray = screen.ray(x + 0.5, y + 0.5);
            covered += std::any_of(balls.begin(), balls.end(),
                                   [&](const Ball& ball) { return sees(ray, ball); });
        }
    }
    const double share = double(covered) / double(screen.size().area());
    RecordProperty("covered_pixels", covered);
    EXPECT_NEAR(share, 0.6, 0.02) << covered << " pixels";
}

}  // namespace
}  // namespace luch::assets
