#include "tests/testing/everything.h"
#include "tests/testing/meshes.h"
#include "tests/trace/path_estimate.h"

#include <gtest/gtest.h>

// White things in a white world: no light is lost, and none is made.
namespace luch {
namespace {

using testing::PathBench;

Geometry faceted_ball() {
    Mesh mesh = testing::uv_sphere(8, 12, 1);
    mesh.faceted = true;
    return mesh;
}

/// A white floor with three white things on it, which light one another.
Scene white_things(bool pictured_sky) {
    Scene scene = testing::dark_scene();
    if (pictured_sky) {
        testing::set_sky(scene, Rgb(1));
    } else {
        scene.environment = ConstantEnvironment{Rgb(1)};
    }
    const Lambert white{.color = Rgb(1)};
    testing::add(scene, Plane{.limit = 50}, white);
    testing::add(scene, Sphere{.centre = {0, 1, 0}, .radius = 1}, white);
    testing::add(scene, Cube{.centre = {2, 0.7, 0}, .side = 1.4}, white);
    testing::add(scene, faceted_ball(), white, Transform::translation({-2, 0.9, 0.3}));
    return scene;
}

TEST(PathFurnace, ShowsWhiteThingsAsBrightAsTheSkyHoweverLightIsFound) {
    for (const bool pictured : {false, true}) {
        const PathBench bench(white_things(pictured));
        for (const Vec3d& target : {Vec3d(0, 0.6, -0.8), Vec3d(1.5, 0, -0.3), Vec3d(2, 0.4, -0.7),
                                    Vec3d(-1.9, 0.7, -0.5)}) {
            for (const auto& [name, settings] : testing::all_ways(1000)) {
                const auto seen =
                    bench.measured(testing::ray_to({0.3, 3, -9}, target), settings, 400);
                EXPECT_LE(seen.sigmas_from(Vec3d(1)), 3) << name << " " << pictured;
                EXPECT_LT(seen.error.x, 0.15) << name;
            }
        }
    }
}

TEST(PathFurnace, LosesWhatAShortPathCannotReach) {
    const PathBench bench(white_things(false));
    const Ray corner = testing::ray_to({0.3, 3, -9}, {1.2, 0, 0});
    const auto seen = bench.measured(corner, {.depth = 1}, 2000);
    EXPECT_LT(seen.mean.x + 10 * seen.error.x, 1);
}

TEST(PathFurnace, FillsAHollowWithTheGeometricSeriesOfItsAlbedo) {
    Scene scene = testing::dark_scene();
    // Half of the inner surface glows, half is white: 1/2 + 1/4 + 1/8 + … = 1 everywhere.
    scene.materials = {Const{.color = Rgb(1)}, Lambert{.color = Rgb(1)},
                       Layered{{{0, Rgb(1)}, {1, Rgb(0.5f)}}}};
    scene.geometries.emplace_back(Sphere{});
    add_node(scene, "hollow", 0, 2, {});
    const PathBench bench(std::move(scene));
    for (const auto& [name, settings] : testing::all_ways(1000)) {
        const auto seen = bench.measured({{0.3, 0, 0}, {0, 0, 1}}, settings, 4000);
        EXPECT_LE(seen.sigmas_from(Vec3d(1)), 3) << name;
        EXPECT_LT(seen.error.x, 0.02) << name;
    }
}

TEST(PathFurnace, GivesBackAllThatPhongTakesSeenFromStraightAbove) {
    for (const double exponent : {0.0, 1.0, 10.0, 1000.0, 1e6}) {
        Scene scene = testing::dark_scene();
        testing::set_sky(scene, Rgb(1));
        testing::add(scene, Plane{},
                     Phong{.color = Rgb(0.4f), .specular = Rgb(1), .exponent = exponent});
        const PathBench bench(std::move(scene));
        for (const auto& [name, settings] : testing::all_ways(4)) {
            // The sky's cells are far larger than the sharpest highlights.
            const bool blind = settings.sampling == PathSampling::light || !settings.mis;
            if (blind && exponent > 10) continue;
            const auto seen = bench.measured({{0, 2, 0}, {0, -1, 0}}, settings, 4000);
            EXPECT_LE(seen.sigmas_from(Vec3d(1)), 3) << name << " " << exponent;
        }
    }
}

TEST(PathFurnace, GivesBackNoMoreThanCameFromPhongAndLayers) {
    for (const double exponent : {0.0, 3.0, 100.0}) {
        Scene scene = testing::dark_scene();
        testing::set_sky(scene, Rgb(1));
        scene.textures.emplace_back(Fresnel{.ior = 1.5});
        scene.materials = {Lambert{.color = Rgb(1)},
                           Phong{.color = Rgb(0.8f), .exponent = exponent},
                           Reflection{.multiplier = Rgb(1), .glossiness = 0.8},
                           Layered{{{0, Rgb(1)}, {1, {0.2f, 0.5f, 0.9f}}, {2, Rgb(1), 0}}}};
        scene.geometries.emplace_back(Sphere{});
        add_node(scene, "ball", 0, 3, {});
        const PathBench bench(std::move(scene));
        for (const double height : {0.0, 0.5, 0.9, 0.99}) {
            for (const auto& [name, settings] : testing::all_ways(8)) {
                const auto seen = bench.measured({{0, height, -3}, {0, 0, 1}}, settings, 2000);
                EXPECT_LE(seen.mean.y, 1 + 3 * seen.error.y + 1e-9) << name << " " << height;
                EXPECT_GE(seen.mean.y, 0.6) << name << " " << height;
            }
        }
    }
}

TEST(PathFurnace, ShowsTheSkyInAWhiteMirrorAndThroughClearGlass) {
    Scene scene = testing::dark_scene();
    scene.environment = ConstantEnvironment{Rgb(1)};
    testing::add(scene, Sphere{}, Refraction{.multiplier = Rgb(1), .ior = 1.5});
    testing::add(scene, Plane{.y = -1}, Reflection{.multiplier = Rgb(1), .glossiness = 0.6});
    const PathBench bench(std::move(scene));
    for (const Vec3d& target : {Vec3d(0.1, 0.2, 0), Vec3d(2, -1, 0)}) {
        const auto seen = bench.measured(testing::ray_to({0, 1, -4}, target), {.depth = 50}, 500);
        EXPECT_LE(seen.sigmas_from(Vec3d(1)), 3);
    }
}

}  // namespace
}  // namespace luch
