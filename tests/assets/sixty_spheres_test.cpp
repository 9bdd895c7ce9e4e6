#include "scenes/generator/sixty_spheres.h"

#include <gtest/gtest.h>

#include <algorithm>

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
    std::vector<int> colours;
    for (const Ball& ball : balls) colours.push_back(ball.colour);
    for (int colour = 0; colour < 8; ++colour) {
        EXPECT_NE(std::count(colours.begin(), colours.end(), colour), 0) << colour;
    }
}

}  // namespace
}  // namespace luch::assets
