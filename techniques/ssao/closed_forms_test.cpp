// Occlusion that is known by analysis. Nothing fades: a hit within the radius occludes fully.
#include "techniques/ssao/rays.h"
#include "techniques/ssao/ssao.h"
#include "tests/testing/scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

namespace luch::techniques::ssao {
namespace {

using testing::OwnStudio;
using testing::plane_of;

constexpr double pi = std::numbers::pi;

/// A wall at distance d = u·R: the directions that meet it within R project to a segment of the
/// disc.
double corner(double u) {
    return u >= 1 ? 0 : (std::acos(u) - u * std::sqrt(1 - u * u)) / pi;
}

/// By rays, at a point of the plane y = 0 that is seen from above.
double traced(const Scene& scene, const Vec3d& at, double radius) {
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    const Ray down{at + Vec3d(0, 1e-4, 0), {0, -1, 0}};
    const Hit hit = tracer.closest(RayKind::primary, down);
    EXPECT_TRUE(hit);
    return traced_occlusion(surface_at(scene, down, hit), radius, 1 << 14, Key(3), tracer);
}

/// A floor, and a wall that stands on the line x = 0 of it, leaning by an angle from the floor.
Scene wedge(double angle) {
    Scene scene = testing::empty_scene();
    testing::add_shape(scene, Plane{});
    // Plane y = 0, turned around z.
    const Transform turn = Transform::rotation(0, 0, angle);
    testing::add_shape(scene, Plane{}, turn);
    return scene;
}

TEST(TracedOcclusion, IsTheClosedFormOfACorner) {
    const Scene scene = wedge(pi / 2);
    for (const double d : {0.01, 0.1, 0.3, 0.5, 0.9, 0.99, 1.5}) {
        EXPECT_NEAR(traced(scene, {d * 2, 0, 0}, 2), corner(d), 1e-3) << d;
    }
}

TEST(TracedOcclusion, IsTheClosedFormOfAnInfiniteWedge) {
    for (const double degrees : {30.0, 60.0, 90.0, 120.0, 150.0}) {
        const double angle = degrees * pi / 180;
        // Where the leaning plane goes up on the side of x > 0.
        for (const double turn : {angle, -angle}) {
            const Scene scene = wedge(turn);
            const double x = turn > 0 ? 1 : -1;
            const double right = traced(scene, {x, 0, 0}, 1e5),
                         left = traced(scene, {-x, 0, 0}, 1e5);
            // One side of the floor is in the wedge of `angle`, the other in that of π − angle.
            const double sum = right + left;
            EXPECT_NEAR(sum, 1, 2e-3) << degrees;
            EXPECT_NEAR(std::max(right, left), (1 + std::abs(std::cos(angle))) / 2, 1e-3)
                << degrees;
        }
    }
}

TEST(TracedOcclusion, IsTheClosedFormOfASphereAbove) {
    for (const double height : {1.001, 1.5, 2.0, 5.0}) {
        Scene scene = testing::empty_scene();
        testing::add_shape(scene, Plane{});
        testing::add_shape(scene, Sphere{.centre = {0, height, 0}, .radius = 1});
        // Whole only for a radius that reaches the farthest point that is seen, √(h² − r²).
        const double whole = std::sqrt(height * height - 1) + 1e-3;
        EXPECT_NEAR(traced(scene, {0, 0, 0}, whole), 1 / (height * height), 1e-3) << height;
        EXPECT_LT(traced(scene, {0, 0, 0}, height - 1 - 1e-6), 1e-3) << height;
    }
}

/// A floor and a wall that leans back, seen from before.
Scene seen_wedge(double degrees) {
    Scene scene = testing::empty_scene();
    scene.settings.ambient_light = Rgb(1);
    scene.lights.clear();
    scene.camera.position = {0, 3, -6};
    scene.camera.pitch_deg = -20;
    scene.camera.fov_deg = 75;
    testing::add_shape(scene, Plane{.limit = 40});
    // Turned around x: for 90° its front is the plane z = 0.
    testing::add_shape(scene, Plane{.limit = 40},
                       Transform::rotation(0, (180 - degrees) * pi / 180, 0));
    return scene;
}

struct Seen {
    double mean_off = 0, worst_bias = 0;
    int count = 0;
};

/// What a mode finds on the floor, against what holds at its distance from the wall.
template <class Expected>
Seen on_the_floor(const Scene& scene, const char* mode, double radius, Expected&& expected) {
    const OwnStudio studio(scene);
    const std::unique_ptr<Technique> technique = make(reference(), {});
    for (const std::string& param :
         {std::string(mode), fmt::format("radius={}", radius), std::string("samples=72")}) {
        set_param(*technique, param);
    }
    const Outcome outcome = studio.render(*technique);
    const auto& visibility = plane_of<float>(outcome, "visibility");
    const Screen screen(scene.camera, scene.settings.frame);
    Seen seen;
    double bias = 0;
    for (int y = 0; y < visibility.height(); ++y) {
        const Ray ray = screen.ray(visibility.width() / 2.0, y + 0.5);
        if (ray.direction.y >= 0) continue;
        const double z = ray.at(-ray.origin.y / ray.direction.y).z;
        const double want = z < 0 ? expected(-z) : -1;
        if (want < 0) continue;
        const int x = visibility.width() / 2;
        for (int i = x - 8; i < x + 8; ++i) {
            const double off = 1 - visibility(i, y) - want;
            seen.mean_off += std::abs(off);
            bias += off;
            ++seen.count;
        }
    }
    seen.mean_off /= seen.count;
    seen.worst_bias = std::abs(bias / seen.count);
    return seen;
}

TEST(Ssao, ComesCloseToTheClosedFormOfACorner) {
    const double radius = 2;
    const auto expected = [&](double d) { return d < 3 ? corner(d / radius) : -1; };
    for (const char* mode : {"mode=bitmask", "mode=gtao"}) {
        const Seen seen = on_the_floor(seen_wedge(90), mode, radius, expected);
        EXPECT_GT(seen.count, 300);
        EXPECT_LT(seen.mean_off, 0.02) << mode;
        EXPECT_LT(seen.worst_bias, 0.015) << mode;
    }
    EXPECT_LT(on_the_floor(seen_wedge(90), "mode=rays", radius, expected).mean_off, 0.01);
}

TEST(Ssao, ComesCloseToTheClosedFormOfAWedge) {
    for (const double degrees : {110.0, 135.0, 150.0}) {
        const double whole = (1 + std::cos(degrees * pi / 180)) / 2;
        const auto expected = [&](double d) { return d > 0.05 && d < 0.2 ? whole : -1; };
        for (const char* mode : {"mode=bitmask", "mode=gtao", "mode=rays"}) {
            const Seen seen = on_the_floor(seen_wedge(degrees), mode, 4, expected);
            EXPECT_GT(seen.count, 16);
            EXPECT_LT(seen.mean_off, 0.05) << mode << " " << degrees;
        }
    }
}

}  // namespace
}  // namespace luch::techniques::ssao
