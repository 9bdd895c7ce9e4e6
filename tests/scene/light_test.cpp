#include "tests/scene/scene_file.h"

#include <numbers>

namespace luch {
namespace {

using Lights = SceneFile;

constexpr double degrees = std::numbers::pi / 180;

Vec3d at_angle(double angle_deg) {
    return {std::sin(angle_deg * degrees), -std::cos(angle_deg * degrees), 0};
}

TEST(SpotLight, FallsOffSmoothlyBetweenItsTwoCones) {
    const SpotLight light{.inner_cosine = std::cos(20 * degrees),
                          .outer_cosine = std::cos(40 * degrees)};
    EXPECT_EQ(light.falloff(at_angle(0)), 1);
    EXPECT_EQ(light.falloff(at_angle(19.999)), 1);
    EXPECT_EQ(light.falloff(at_angle(40.001)), 0);
    EXPECT_EQ(light.falloff({0, 1, 0}), 0);
    const double half_way = (light.inner_cosine + light.outer_cosine) / 2;
    EXPECT_NEAR(light.falloff({std::sqrt(1 - half_way * half_way), -half_way, 0}), 0.5, 1e-12);
    EXPECT_GT(light.falloff(at_angle(25)), light.falloff(at_angle(35)));
}

TEST(SpotLight, MayHaveASharpRim) {
    const double rim = std::cos(30 * degrees);
    const SpotLight light{.inner_cosine = rim, .outer_cosine = rim};
    EXPECT_EQ(light.falloff(at_angle(29.99)), 1);
    EXPECT_EQ(light.falloff(at_angle(30.01)), 0);
}

TEST_F(Lights, ReadSpotAndDirectionalLights) {
    const Scene scene = loaded(
                            "SpotLight s {\npos 1 2 3\ndirection 0 0 5\ninnerAngle 10\n"
                            "outerAngle 60\ncolor 1 0 0\npower 7\n}\n"
                            "DirectionalLight d {\ndirection -2 0 0\npower 3\n}\n"
                            "SpotLight narrow {\npos 0 0 0\nouterAngle 5\n}",
                            true)
                            .scene;
    const auto& spot = std::get<SpotLight>(scene.lights.at(0));
    EXPECT_EQ(spot.position, Vec3d(1, 2, 3));
    EXPECT_EQ(spot.direction, Vec3d(0, 0, 1));
    EXPECT_NEAR(spot.inner_cosine, std::cos(10 * degrees), 1e-15);
    EXPECT_NEAR(spot.outer_cosine, 0.5, 1e-15);
    EXPECT_EQ(spot.color, Rgb(1, 0, 0));
    EXPECT_EQ(spot.power, 7);
    const auto& sun = std::get<DirectionalLight>(scene.lights.at(1));
    EXPECT_EQ(sun.direction, Vec3d(-1, 0, 0));
    EXPECT_EQ(sun.power, 3);
    const auto& narrow = std::get<SpotLight>(scene.lights.at(2));
    EXPECT_EQ(narrow.inner_cosine, narrow.outer_cosine);
}

TEST_F(Lights, KeepADirectionOfAnyLength) {
    const Scene scene = loaded("DirectionalLight d {\ndirection 0 -1e-200 0\n}").scene;
    EXPECT_EQ(std::get<DirectionalLight>(scene.lights.at(0)).direction, Vec3d(0, -1, 0));
}

TEST_F(Lights, RefuseConesThatAreTurnedInsideOutAndDirectionsThatPointNowhere) {
    EXPECT_EQ(answer("SpotLight s {\npos 0 0 0\ninnerAngle 50\nouterAngle 40\n}"),
              "t.scene:1: SpotLight \"s\" has an innerAngle of 50 and an outerAngle of 40; the "
              "outer one is the larger of the two");
    EXPECT_EQ(answer("DirectionalLight {\ndirection 0 0 0\n}"),
              "t.scene:2: direction is (0, 0, 0), which points nowhere; choose another");
}

TEST_F(Lights, LightEverythingWithAConstantSky) {
    const Scene scene = loaded("ConstantEnvironment sky {\ncolor 1 2 3\n}", true).scene;
    EXPECT_EQ(sky_radiance(scene, {0.3, -0.2, 5}), Rgb(1, 2, 3));
    const std::string two = "ConstantEnvironment {\ncolor 1 2 3\n}\nConstantEnvironment {\n}";
    EXPECT_EQ(sky_radiance(loaded(two).scene, {1, 0, 0}), Rgb(1, 2, 3));
    EXPECT_EQ(answer("ConstantEnvironment a {\n}\nConstantEnvironment b {\n}"),
              "t.scene:3: there is an environment already, and the first one counts; remove one of "
              "the two\n");
}

}  // namespace
}  // namespace luch
