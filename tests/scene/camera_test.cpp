#include "framework/scene/camera.h"

#include "framework/math/rng.h"

#include <gtest/gtest.h>

#include <numbers>

namespace luch {
namespace {

constexpr double pi = std::numbers::pi;

Camera camera_of(Projection projection, double fov_deg = 90) {
    Camera camera;
    camera.projection = projection;
    camera.fov_deg = fov_deg;
    return camera;
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance = 1e-12) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << "axis " << k;
}

/// Every point of the frame that has a ray is found again on it, at any distance.
void expect_there_and_back(const Camera& camera, Size size, double tolerance_px) {
    const Screen screen(camera, size);
    int rays = 0;
    for (int i = 0; i < 500; ++i) {
        const Vec2d p = Key(5).branch(i).square(0) * Vec2d(size.width, size.height);
        const Ray ray = screen.ray(p.x, p.y);
        if (nowhere(ray)) continue;
        ++rays;
        EXPECT_NEAR(glm::length(ray.direction), 1, 1e-14);
        const double distance = std::exp(10 * Key(6).uniform(i) - 5);
        const auto back = screen.project(screen.to_view(ray.at(distance)));
        ASSERT_TRUE(back) << p.x << " " << p.y;
        EXPECT_NEAR(back->x, p.x, tolerance_px);
        EXPECT_NEAR(back->y, p.y, tolerance_px);
    }
    EXPECT_GT(rays, 100);
}

TEST(Screen, FindsEveryPointAgainInEveryProjection) {
    Camera camera = camera_of(Projection::perspective);
    camera.position = {3, -2, 7};
    camera.yaw_deg = 40;
    camera.roll_deg = 25;
    for (const Projection projection : {Projection::perspective, Projection::fisheye,
                                        Projection::spherical, Projection::orthographic}) {
        camera.projection = projection;
        for (const double pitch : {-90.0, -20.0, 90.0}) {
            camera.pitch_deg = pitch;
            for (const Size size : {Size{640, 480}, Size{1, 1}, Size{7, 300}}) {
                expect_there_and_back(camera, size, 1e-7);
            }
        }
    }
}

TEST(Screen, FindsEveryPointAgainAtTheExtremesOfTheFieldOfView) {
    expect_there_and_back(camera_of(Projection::perspective, 0.0001), {640, 480}, 1e-6);
    expect_there_and_back(camera_of(Projection::perspective, 179), {640, 480}, 1e-9);
    expect_there_and_back(camera_of(Projection::fisheye, 1), {640, 480}, 1e-9);
    // Near the rim of the full sphere one direction, straight behind, is the whole circle.
    expect_there_and_back(camera_of(Projection::fisheye, 360), {640, 480}, 1e-7);
}

TEST(Fisheye, TurnsByTheSameAngleForEveryPixel) {
    const Screen screen(camera_of(Projection::fisheye, 180), {400, 300});
    for (int i = 0; i <= 10; ++i) {
        const double angle = pi / 2 * i / 10;
        expect_near(screen.ray(200 + 15.0 * i, 150).direction,
                    {std::sin(angle), 0, std::cos(angle)});
        expect_near(screen.ray(200, 150 - 15.0 * i).direction,
                    {0, std::sin(angle), std::cos(angle)});
    }
}

TEST(Fisheye, HasNoRayOutsideItsDisc) {
    const Screen screen(camera_of(Projection::fisheye, 180), {400, 300});
    EXPECT_TRUE(nowhere(screen.ray(2, 2)));
    EXPECT_TRUE(nowhere(screen.ray(200 + 150.1, 150)));
    EXPECT_FALSE(nowhere(screen.ray(200 + 149.9, 150)));
    EXPECT_FALSE(screen.project({0, 0, -1}));
    EXPECT_FALSE(screen.project({1, 0, -0.01}));
    EXPECT_TRUE(screen.project({1, 0, 0.01}));
}

TEST(Fisheye, SpansItsAngleOverTheShorterSide) {
    Camera tall = camera_of(Projection::fisheye, 200);
    tall.aspect = 0.5;
    const Screen screen(tall, {300, 600});
    const double half = 100 * pi / 180;
    expect_near(screen.ray(300, 300).direction, {std::sin(half), 0, std::cos(half)});
    EXPECT_TRUE(nowhere(screen.ray(150, 0)));
}

TEST(Spherical, ShowsAllDirectionsWithForwardInTheMiddle) {
    const Screen screen(camera_of(Projection::spherical), {360, 180});
    expect_near(screen.ray(180, 90).direction, {0, 0, 1});
    expect_near(screen.ray(270, 90).direction, {1, 0, 0});
    expect_near(screen.ray(90, 90).direction, {-1, 0, 0});
    expect_near(screen.ray(360, 90).direction, {0, 0, -1});
    expect_near(screen.ray(77, 0).direction, {0, 1, 0});
    expect_near(screen.ray(77, 180).direction, {0, -1, 0});
    EXPECT_FALSE(screen.project(Vec3d(0)));
}

TEST(Orthographic, SendsParallelRaysAcrossItsWidth) {
    Camera camera = camera_of(Projection::orthographic);
    camera.width = 8;
    camera.aspect = 2;
    camera.position = {1, 2, 3};
    const Screen screen(camera, {200, 100});
    for (const Vec2d p : {Vec2d(0, 0), Vec2d(200, 100), Vec2d(31, 62)}) {
        expect_near(screen.ray(p.x, p.y).direction, {0, 0, 1});
    }
    expect_near(screen.ray(0, 0).origin, {1 - 4, 2 + 2, 3});
    expect_near(screen.ray(200, 100).origin, {1 + 4, 2 - 2, 3});
}

Camera with_lens(double f_number) {
    Camera camera = camera_of(Projection::perspective);
    camera.depth_of_field = true;
    camera.f_number = f_number;
    camera.focal_distance = 7;
    camera.position = {1, 2, 3};
    camera.yaw_deg = 30;
    camera.pitch_deg = 20;
    return camera;
}

TEST(Lens, MeetsInThePlaneOfFocusFromAllOverItsDisc) {
    const Screen screen(with_lens(2), {64, 48});
    const Ray middle = screen.ray(10, 40);
    const Vec3d focus = middle.at(7 / glm::dot(middle.direction, screen.forward()));
    for (const Vec2d lens : {Vec2d(1, 0), Vec2d(0, -1), Vec2d(-0.6, 0.5)}) {
        const Ray ray = screen.ray(10, 40, lens);
        EXPECT_NEAR(glm::distance(ray.origin, screen.eye()), glm::length(lens) * 2.5 / 2, 1e-12);
        EXPECT_NEAR(glm::dot(ray.origin - screen.eye(), screen.forward()), 0, 1e-12);
        expect_near(ray.at(glm::distance(ray.origin, focus)), focus, 1e-11);
    }
}

TEST(Lens, IsAPinholeBitForBitWithoutDepthOfField) {
    Camera camera = with_lens(0.5);
    camera.depth_of_field = false;
    const Screen screen(camera, {64, 48});
    for (int i = 0; i < 100; ++i) {
        const Vec2d p = 60.0 * Key(1).square(i), lens = Key(2).square(i);
        const Ray one = screen.ray(p.x, p.y), other = screen.ray(p.x, p.y, lens);
        EXPECT_EQ(one.origin, other.origin);
        EXPECT_EQ(one.direction, other.direction);
    }
}

TEST(Lens, BelongsToPerspectiveOnly) {
    Camera camera = with_lens(1);
    EXPECT_TRUE(camera.has_lens());
    EXPECT_EQ(camera.lens_radius(), 2.5);
    camera.projection = Projection::fisheye;
    EXPECT_FALSE(camera.has_lens());
    EXPECT_EQ(camera.lens_radius(), 0);
}

TEST(Eyes, StandAsideByHalfTheSeparationAndLookAhead) {
    Camera camera = with_lens(1);
    camera.stereo_separation = 6;
    const Vec3d right = camera.to_world().direction({1, 0, 0});
    const Camera left_eye = camera.left_eye(), right_eye = camera.right_eye();
    expect_near(left_eye.position, camera.position - 3.0 * right);
    expect_near(right_eye.position, camera.position + 3.0 * right);
    EXPECT_EQ(left_eye.yaw_deg, camera.yaw_deg);
    EXPECT_EQ(right_eye.stereo_separation, 0);
}

}  // namespace
}  // namespace luch
