#include "framework/trace/optics.h"
#include "framework/trace/whitted.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace luch {
namespace {

constexpr double degrees = std::numbers::pi / 180;

Rgb seen(const Scene& scene, const Ray& ray, Counts* counts = nullptr) {
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    const Rgb colour = Whitted(scene, Needs(), tracer).radiance(RayKind::primary, ray, Key(1));
    if (counts) *counts = tracer.counts();
    return colour;
}

void expect_near(const Rgb& a, const Rgb& b, float tolerance = 1e-5f) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << "channel " << k;
}

/// A white sky, and nothing else.
Scene under_white_sky() {
    Scene scene = testing::empty_scene();
    scene.lights.clear();
    scene.settings.ambient_light = Rgb(0);
    scene.settings.background = Rgb(1);
    return scene;
}

/// A clear slab 2 thick: y from −1 to 1.
void add_slab(Scene& scene, const Refraction& glass) {
    testing::add(scene, Cube{.side = 2}, glass, Transform::scaling({1000, 1, 1000}));
}

const Ray straight_down{{0, 5, 0}, {0, -1, 0}};

TEST(Refraction, FollowsSnellsLaw) {
    const Vec3d normal{0, 1, 0};
    for (const double angle : {0.0, 1.0, 30.0, 60.0, 89.0}) {
        const Vec3d direction{std::sin(angle * degrees), -std::cos(angle * degrees), 0};
        const auto bent = refracted(direction, normal, 1 / 1.5);
        ASSERT_TRUE(bent);
        EXPECT_NEAR(bent->x, std::sin(angle * degrees) / 1.5, 1e-12) << angle;
        EXPECT_NEAR(glm::length(*bent), 1, 1e-15);
        EXPECT_LT(bent->y, 0);
    }
}

TEST(Refraction, IsTotallyReflectedBeyondTheCriticalAngle) {
    const double critical = std::asin(1 / 1.5) / degrees;
    const auto leaves = [](double angle) {
        return refracted({std::sin(angle * degrees), -std::cos(angle * degrees), 0}, {0, 1, 0}, 1.5)
            .has_value();
    };
    EXPECT_TRUE(leaves(critical - 0.001));
    EXPECT_FALSE(leaves(critical + 0.001));
}

TEST(Refraction, BendsARayThroughASlabToAParallelOne) {
    Scene scene = under_white_sky();
    add_slab(scene, {.multiplier = Rgb(1), .ior = 1.5});
    // A red wall where the shifted ray must arrive, and nowhere else.
    const double shift = 2 * std::tan(std::asin(std::sin(45 * degrees) / 1.5));
    testing::add(scene, Cube{.centre = {shift, -3, 0}, .side = 1e-3}, Const{.color = {1, 0, 0}});
    const Ray slanted{{-3, 4, 0}, glm::normalize(Vec3d(1, -1, 0))};  // enters at (0, 1)
    const Ray exact{slanted.origin - Vec3d(2, 0, 0), slanted.direction};
    expect_near(seen(scene, exact), {1, 0, 0});
    expect_near(seen(scene, slanted), {1, 1, 1});
}

TEST(Refraction, CountsItsRaysAndMultipliesAtBothSurfaces) {
    Scene scene = under_white_sky();
    add_slab(scene, {.multiplier = {0.5f, 1, 1}});
    Counts counts;
    expect_near(seen(scene, straight_down, &counts), {0.25f, 1, 1});
    EXPECT_EQ(counts.of(RayKind::refraction), 2u);
    EXPECT_EQ(counts.of(RayKind::primary), 1u);
}

TEST(Refraction, IsBlackWhereTheReflectionIsTotal) {
    Scene scene = under_white_sky();
    testing::add(scene, Plane{}, Refraction{.multiplier = Rgb(1), .ior = 1.5});
    const Ray from_below{{0, -1, 0}, glm::normalize(Vec3d(2, 1, 0))};
    expect_near(seen(scene, from_below), Rgb(0));
    expect_near(seen(scene, {{0, -1, 0}, {0, 1, 0}}), Rgb(1));
}

TEST(Refraction, ChangesNothingWithTheIndexOfAir) {
    Scene scene = under_white_sky();
    testing::add(scene, Sphere{.radius = 2}, Refraction{.multiplier = Rgb(1), .ior = 1});
    testing::add(scene, Cube{.centre = {1, -5, 0}, .side = 1e-3}, Const{.color = {1, 0, 0}});
    expect_near(seen(scene, {{1, 5, 0}, {0, -1, 0}}), {1, 0, 0});
}

TEST(Refraction, FadesByBeersLawOverTheWayInside) {
    Scene scene = under_white_sky();
    add_slab(scene,
             {.multiplier = Rgb(1), .ior = 1, .inside_color = {0.5f, 0.1f, 1}, .absorption = 0.7});
    const auto left = [](double way) {
        return Rgb(std::exp(-0.7 * way * 0.5), std::exp(-0.7 * way * 0.9), 1);
    };
    expect_near(seen(scene, straight_down), left(2));
    expect_near(seen(scene, {{0, 5, 0}, glm::normalize(Vec3d(1, -1, 0))}),
                left(2 * std::sqrt(2.0)));
}

TEST(Refraction, FadesNoMoreBehindTheGlass) {
    Scene scene = under_white_sky();
    add_slab(scene, {.multiplier = Rgb(1), .ior = 1, .inside_color = Rgb(0), .absorption = 0.5});
    testing::add(scene, Plane{.y = -7}, Const{.color = Rgb(1)});
    expect_near(seen(scene, straight_down), Rgb(std::exp(-1.0f)));
}

TEST(Refraction, FadesByTheWayInWorldUnitsWhateverTheLengthOfTheDirection) {
    Scene scene = under_white_sky();
    testing::add(scene, Plane{}, Const{.color = Rgb(1)});
    const Refraction water{.inside_color = Rgb(0), .absorption = 0.5};
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    const Ray long_one{{0, 4, 0}, {0, -8, 0}};
    expect_near(Whitted(scene, Needs(), tracer).radiance(RayKind::gi, long_one, Key(1), 0, &water),
                Rgb(std::exp(-2.0f)));
}

TEST(Refraction, FadesBeforeAThingThatStandsInside) {
    Scene scene = under_white_sky();
    add_slab(scene, {.multiplier = Rgb(1), .ior = 1, .inside_color = Rgb(0), .absorption = 1});
    testing::add(scene, Cube{.centre = {0, -0.5, 0}, .side = 0.5}, Const{.color = Rgb(1)});
    expect_near(seen(scene, straight_down), Rgb(std::exp(-1.25f)));
}

TEST(Refraction, FadesBetweenTwoReflectionsInside) {
    Scene scene = under_white_sky();
    // A mirror as the slab's floor: in, down 1.5, up 1.5, out.
    add_slab(scene, {.multiplier = Rgb(1), .ior = 1.5, .inside_color = Rgb(0), .absorption = 1});
    testing::add(scene, Plane{.y = -0.5}, Reflection{.multiplier = Rgb(1)});
    expect_near(seen(scene, straight_down), Rgb(std::exp(-3.0f)));
}

TEST(Refraction, EndsAtTheDepthLimit) {
    Scene scene = under_white_sky();
    scene.settings.max_depth = 1;
    add_slab(scene, {.multiplier = Rgb(1)});
    expect_near(seen(scene, straight_down), Rgb(0));
}

TEST(Fresnel, BlendsByTheAngleOfTheRay) {
    Scene scene = under_white_sky();
    scene.settings.background = {0, 0, 1};
    scene.textures.emplace_back(Fresnel{.ior = 1.5});
    testing::add(scene, Plane{}, Const{.color = {1, 0, 0}});
    const auto red = static_cast<MaterialId>(scene.materials.size() - 1);
    scene.materials.emplace_back(Reflection{.multiplier = Rgb(1)});
    scene.materials.emplace_back(Layered{{{red, Rgb(1)}, {red + 1, Rgb(0), 0}}});
    scene.nodes.back().material = red + 2;
    expect_near(seen(scene, straight_down), {0.96f, 0, 0.04f});
    const double cosine = 0.25;
    const Ray slant{{0, 1, 0}, {std::sqrt(1 - cosine * cosine), -cosine, 0}};
    const auto share = static_cast<float>(0.04 + 0.96 * std::pow(0.75, 5));
    expect_near(seen(scene, slant), {1 - share, 0, share});
}

TEST(Bumps, TiltTheNormalOfAPlane) {
    Scene scene = under_white_sky();
    scene.textures.emplace_back(Bumps{.strength = 2});
    testing::add(scene, Plane{}, Const{});
    scene.nodes.back().bump = 0;
    const Ray ray{{3, 1, 7}, {0, -1, 0}};
    const Hit hit = closest_brute(scene, ray);
    const auto wave = [](double at, double a, double b, double c) {
        return 2 * (0.1 * std::sin(0.2 * a * at) + 0.08 * std::sin(0.2 * b * at) +
                    0.05 * std::sin(0.2 * c * at));
    };
    const Vec3d expected =
        glm::normalize(Vec3d(wave(3, 0.5, 1.21, 1.9), 1, wave(7, 0.4, 1.13, 1.81)));
    EXPECT_LT(max_norm(surface_at(scene, ray, hit).normal - expected), 1e-12);
}

TEST(SpotLight, LightsItsConeOnly) {
    Scene scene = testing::empty_scene();
    scene.settings.ambient_light = Rgb(0);
    scene.lights = {SpotLight{.position = {0, 2, 0},
                              .inner_cosine = std::cos(20 * degrees),
                              .outer_cosine = std::cos(30 * degrees),
                              .power = 8}};
    testing::add(scene, Plane{}, Lambert{.color = Rgb(0.5f)});
    const auto at = [&](double x) { return seen(scene, {{x, 1, 0}, {0, -1, 0}}); };
    expect_near(at(0), Rgb(1));  // 0.5 · 8/2²
    expect_near(at(2 * std::tan(31 * degrees)), Rgb(0));
    EXPECT_GT(at(2 * std::tan(25 * degrees)).r, 0.1f);
}

TEST(DirectionalLight, LightsAtAnyDistanceByTheCosineAndCastsShadows) {
    Scene scene = testing::empty_scene();
    scene.settings.ambient_light = Rgb(0);
    scene.lights = {
        DirectionalLight{.direction = {0, -0.6, 0.8}, .color = {1, 0.5f, 0}, .power = 2}};
    testing::add(scene, Plane{}, Lambert{.color = Rgb(1)});
    testing::add(scene, Cube{.centre = {500, 50, 0}, .side = 10}, Const{});
    const auto at = [&](double x, double z) { return seen(scene, {{x, 1, z}, {0, -1, 0}}); };
    expect_near(at(0, 0), Rgb(1.2f, 0.6f, 0));
    expect_near(at(1e6, 0), Rgb(1.2f, 0.6f, 0));
    expect_near(at(500, 50 * 0.8 / 0.6), Rgb(0));
}

}  // namespace
}  // namespace luch
