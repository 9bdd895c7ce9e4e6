#include "framework/window/fly.h"

#include <gtest/gtest.h>

#include <numbers>

namespace luch {
namespace {

Camera tilted_camera() {
    Camera camera;
    camera.position = {12, 60, -150};
    camera.yaw_deg = 34;
    camera.pitch_deg = -21;
    camera.roll_deg = 7;
    return camera;
}

Vec3d axis(const Camera& camera, const Vec3d& of_camera) {
    return camera.to_world().direction(of_camera);
}

void expect_same_view(const Camera& a, const Camera& b) {
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.yaw_deg, b.yaw_deg);
    EXPECT_EQ(a.pitch_deg, b.pitch_deg);
    EXPECT_EQ(a.roll_deg, b.roll_deg);
}

TEST(Fly, ManyShortStepsGoAsFarAsOneLongOne) {
    FlyKeys keys;
    keys.forward = keys.right = keys.up = true;
    const Camera start = tilted_camera();
    const Camera once = flown(start, keys, 64);
    Camera often = start;
    for (int i = 0; i < 64; ++i) often = flown(often, keys, 1);
    EXPECT_LT(glm::distance(once.position, often.position), 1e-11);
    EXPECT_NEAR(glm::distance(once.position, start.position), 64, 1e-11);
}

TEST(Fly, EachKeyMovesItsOwnWay) {
    const Camera start = tilted_camera();
    const auto step = [&](bool FlyKeys::*key) {
        FlyKeys keys;
        keys.*key = true;
        return flown(start, keys, 1).position - start.position;
    };
    const auto expect_near = [](const Vec3d& a, const Vec3d& b) {
        EXPECT_LT(glm::distance(a, b), 1e-12);
    };
    expect_near(step(&FlyKeys::forward), axis(start, {0, 0, 1}));
    expect_near(step(&FlyKeys::back), axis(start, {0, 0, -1}));
    expect_near(step(&FlyKeys::right), axis(start, {1, 0, 0}));
    expect_near(step(&FlyKeys::left), axis(start, {-1, 0, 0}));
    expect_near(step(&FlyKeys::up), {0, 1, 0});
    expect_near(step(&FlyKeys::down), {0, -1, 0});
}

TEST(Fly, AMillionIdleTurnsDoNotMoveTheCamera) {
    const Camera start = tilted_camera();
    FlyKeys opposite;
    opposite.forward = opposite.back = true;
    Camera camera = start;
    for (int i = 0; i < 1'000'000; ++i) {
        camera = turned(camera, {0, 0}, 0.1);
        camera = flown(camera, i % 2 == 0 ? FlyKeys{} : opposite, 1);
    }
    expect_same_view(camera, start);
}

TEST(Fly, DraggingTurnsToTheSideOfTheMouse) {
    Camera camera = tilted_camera();
    camera.roll_deg = 0;
    const Vec3d right = turned(camera, {10, 0}, 0.5).to_world().direction({0, 0, 1});
    EXPECT_GT(glm::dot(right, axis(camera, {1, 0, 0})), 0.05);
    const Vec3d down = turned(camera, {0, 10}, 0.5).to_world().direction({0, 0, 1});
    EXPECT_LT(glm::dot(down, axis(camera, {0, 1, 0})), -0.05);
}

TEST(Fly, PitchStopsStraightUpAndStraightDown) {
    const Camera camera = tilted_camera();
    EXPECT_EQ(turned(camera, {0, -1e6}, 0.5).pitch_deg, 90);
    EXPECT_EQ(turned(camera, {0, 1e6}, 0.5).pitch_deg, -90);
}

TEST(Fly, YawStaysWithinHalfATurn) {
    Camera camera = tilted_camera();
    for (int i = 0; i < 1000; ++i) {
        camera = turned(camera, {37, 0}, 0.5);
        ASSERT_LE(std::abs(camera.yaw_deg), 180);
    }
    const double expected = std::remainder(34 - 1000 * 37 * 0.5, 360.0);
    EXPECT_NEAR(camera.yaw_deg, expected, 1e-9);
}

TEST(Fly, ADragAcrossTheFrameTurnsByItsFieldOfView) {
    Camera camera;
    camera.fov_deg = 80;
    const Screen screen(camera, {640, 480});
    const Vec3d left = screen.ray(0, 240).direction, right = screen.ray(640, 240).direction;
    const double angle_deg = std::acos(glm::dot(left, right)) * 180 / std::numbers::pi;
    EXPECT_NEAR(degrees_per_px(camera, 640) * 640, angle_deg, 1e-9);
}

TEST(Fly, ADragAcrossTheFrameTurnsByTheFieldOfViewOfEveryProjection) {
    Camera camera;
    camera.aspect = 2;
    camera.fov_deg = 150;
    camera.projection = Projection::fisheye;
    EXPECT_NEAR(degrees_per_px(camera, 640) * 640, 300, 1e-9);
    camera.projection = Projection::spherical;
    EXPECT_NEAR(degrees_per_px(camera, 640) * 640, 360, 1e-9);
    camera.projection = Projection::orthographic;
    EXPECT_NEAR(degrees_per_px(camera, 640) * 640, 90, 1e-9);
}

TEST(Fly, SpeedFollowsTheSizeOfTheScene) {
    const auto scene_at = [](double scale) {
        Scene scene;
        scene.camera.position = {0, 0, -4 * scale};
        scene.geometries.emplace_back(Sphere{{0, 0, 0}, scale, 1});
        scene.materials.emplace_back(Const{});
        add_node(scene, "ball", 0, 0, Transform{});
        return scene;
    };
    EXPECT_NEAR(flying_speed(scene_at(1)), 1, 1e-12);
    EXPECT_NEAR(flying_speed(scene_at(1e6)) / flying_speed(scene_at(1e-6)), 1e12, 1);
}

TEST(Fly, SpeedIsFiniteWhateverTheScene) {
    Scene scene;
    EXPECT_GT(flying_speed(scene), 0);
    scene.geometries.emplace_back(Plane{});
    scene.materials.emplace_back(Const{});
    add_node(scene, "floor", 0, 0, Transform{});
    EXPECT_GT(flying_speed(scene), 0);
    EXPECT_TRUE(std::isfinite(flying_speed(scene)));
}

}  // namespace
}  // namespace luch
