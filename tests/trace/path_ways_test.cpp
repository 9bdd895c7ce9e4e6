#include "framework/trace/whitted.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"
#include "tests/trace/path_estimate.h"

#include <gtest/gtest.h>

// However light is found, the mean is the same.
namespace luch {
namespace {

using testing::PathBench;

/// Two coloured walls and a floor.
Scene corner(const Material& floor = Lambert{.color = {0.8f, 0.7f, 0.6f}}) {
    Scene scene = testing::dark_scene();
    testing::add(scene, Plane{}, floor);
    testing::add(scene, Plane{.limit = 4}, Lambert{.color = {0.8f, 0.2f, 0.1f}},
                 Transform::rotation(0, 0, std::acos(0)).then(Transform::translation({2, 0, 0})));
    testing::add(scene, Sphere{.centre = {0.3, 0.5, 0.8}, .radius = 0.5}, Lambert{});
    return scene;
}

void add_lamp(Scene& scene, double size, const Vec3d& place, float power) {
    const Transform to_world = Transform::scaling(Vec3d(size))
                                   .then(Transform::rotation(0.3, 0.4, 0))
                                   .then(Transform::translation(place));
    add_rect_light(scene, "lamp", RectLight{.to_world = to_world, .color = Rgb(1), .power = power});
}

Scene small_lamp() {
    Scene scene = corner();
    add_lamp(scene, 0.3, {-0.5, 1, 0}, 4);
    return scene;
}

Scene large_lamp() {
    Scene scene = corner();
    add_lamp(scene, 5, {-0.5, 2.5, 0}, 40);
    add_lamp(scene, 1, {0.5, 1.5, -1}, 5);
    return scene;
}

Scene sunny_sky() {
    Scene scene = corner();
    testing::set_sky(scene, {0.3f, 0.4f, 0.6f});
    auto& sky = std::get<CubemapEnvironment>(*scene.environment);
    sky.sides[CubemapEnvironment::pos_y](4, 6) = Rgb(200, 180, 120);
    return scene;
}

Scene shiny_floor() {
    Scene scene = corner(Phong{.color = {0.3f, 0.2f, 0.1f}, .specular = Rgb(0.9f), .exponent = 60});
    add_lamp(scene, 0.8, {0.4, 1.6, 1}, 6);
    scene.lights.emplace_back(PointLight{.position = {-1, 2, -1}, .power = 2});
    return scene;
}

/// A lamp and a floor within one block of tinted glass.
Scene inside_glass() {
    Scene scene = corner();
    add_lamp(scene, 1, {0, 1.5, 0}, 6);
    testing::add(scene, Cube{.centre = {0, 2, 0}, .side = 12},
                 Refraction{.inside_color = {0.2f, 0.6f, 0.9f}, .absorption = 0.3});
    return scene;
}

TEST(PathWays, AgreeOnFiveScenes) {
    const std::pair<const char*, Scene> scenes[] = {{"small lamp", small_lamp()},
                                                    {"large lamp", large_lamp()},
                                                    {"sunny sky", sunny_sky()},
                                                    {"shiny floor", shiny_floor()},
                                                    {"inside glass", inside_glass()}};
    const auto ways = testing::all_ways(4);
    for (const auto& [scene_name, scene] : scenes) {
        const PathBench bench(scene);
        for (const Vec3d& target : {Vec3d(0.1, 0, 0), Vec3d(1.7, 0, 0.2)}) {
            const Ray ray = testing::ray_to({-0.6, 1.2, -3}, target);
            const auto truth = bench.measured(ray, ways[0].settings, 40000, 2);
            ASSERT_GT(truth.mean.y, 0.01) << scene_name;
            EXPECT_LT(truth.error.y, 0.02 * truth.mean.y) << scene_name;
            for (const auto& [name, settings] : ways) {
                const auto seen = bench.measured(ray, settings, 20000);
                EXPECT_LE(seen.sigmas_from(truth.mean, truth.error), 3)
                    << scene_name << ", " << name << ": " << seen.mean.y << " ± " << seen.error.y
                    << ", not " << truth.mean.y << " ± " << truth.error.y;
            }
        }
    }
}

TEST(PathWays, MultipleImportanceSamplingIsNeverMuchWorseThanTheBetterWay) {
    for (const Scene& scene : {small_lamp(), large_lamp(), shiny_floor()}) {
        const PathBench bench(scene);
        const Ray ray = testing::ray_to({-0.6, 1.2, -3}, {0.1, 0, 0});
        const auto error = [&](const PathSettings& settings) {
            return bench.measured(ray, settings, 10000).error.y;
        };
        const double better = std::min(error({.sampling = PathSampling::light, .depth = 0}),
                                       error({.sampling = PathSampling::bsdf, .depth = 0}));
        EXPECT_LT(error({.depth = 0}), 1.3 * better);
    }
}

/// Mirrors, glass and a layer of both, under a sky.
Scene polished() {
    Scene scene = testing::dark_scene();
    testing::set_sky(scene, {0.2f, 0.5f, 0.9f});
    testing::add(scene, Plane{.y = -1}, Reflection{.multiplier = {0.9f, 0.8f, 0.7f}});
    testing::add(scene, Sphere{.centre = {0, 0, 5}, .radius = 1},
                 Refraction{.ior = 1.5, .inside_color = {0.9f, 0.5f, 0.2f}, .absorption = 0.7});
    testing::add(scene, Cube{.centre = {2.5, 0, 6}, .side = 1.5}, Reflection{},
                 Transform::rotation(0.2, 0.1, 0));
    testing::add(scene, Sphere{.centre = {-2.5, 0.2, 6}, .radius = 1},
                 Const{.color = {0.1f, 2, 0.3f}});
    return scene;
}

TEST(PathWays, AgreeWithTheClassicTracerWhereNothingScatters) {
    const PathBench bench(polished());
    const Screen screen(bench.scene().camera, {24, 18});
    Tracer tracer(bench.accelerator());
    for (const int depth : {0, 1, 2, 8}) {
        Scene limited = bench.scene();
        limited.settings.max_depth = depth;
        for (int y = 0; y < 18; ++y) {
            for (int x = 0; x < 24; ++x) {
                const Ray ray = screen.ray(x + 0.5, y + 0.5);
                const Rgb classic =
                    Whitted(limited, Needs(), tracer).radiance(RayKind::primary, ray, Key(1));
                const Vec3d path = bench.measured(ray, {.roulette = false, .depth = depth}, 2).mean;
                ASSERT_LT(max_norm(path - Vec3d(classic)), 1e-5) << x << " " << y << " " << depth;
            }
        }
    }
}

TEST(PathWays, MixLayersAsTheClassicTracerDoes) {
    Scene scene = testing::dark_scene();
    testing::set_sky(scene, {0.2f, 0.5f, 0.9f});
    scene.textures.emplace_back(Fresnel{.ior = 1.5});
    scene.materials = {Refraction{.multiplier = {1, 0.5f, 1}, .ior = 1.5}, Reflection{},
                       Const{.color = {0.4f, 0, 0.1f}},
                       Layered{{{2, Rgb(1)}, {0, {0.9f, 0.7f, 0.8f}}}},
                       Layered{{{3, Rgb(1)}, {1, Rgb(0), 0}}}};
    scene.geometries.emplace_back(Sphere{});
    add_node(scene, "ball", 0, 4, {});
    const PathBench bench(std::move(scene));
    Tracer tracer(bench.accelerator());
    for (const double height : {0.1, 0.6, 0.95}) {
        const Ray ray{{0, height, -3}, {0, 0, 1}};
        const Rgb classic =
            Whitted(bench.scene(), Needs(), tracer).radiance(RayKind::primary, ray, Key(1));
        const auto path = bench.measured(ray, {.depth = bench.scene().settings.max_depth}, 20000);
        EXPECT_LE(path.sigmas_from(Vec3d(classic)), 3) << height;
    }
}

TEST(PathWays, EndAtTheDepthLimitBetweenTwoMirrors) {
    Scene scene = testing::dark_scene();
    testing::add(scene, Plane{}, Reflection{.multiplier = Rgb(1)});
    testing::add(scene, Plane{.y = 3}, Reflection{.multiplier = Rgb(1)});
    const PathBench bench(std::move(scene));
    Tracer tracer(bench.accelerator());
    PathTracer paths(bench.scene(), bench.lights(), {.depth = 7}, Needs(), tracer);
    EXPECT_EQ(paths.radiance({{0, 1, 0}, {0, -1, 0}}, {Key(1), 0}), Vec3d(0));
    EXPECT_EQ(tracer.counts().of(RayKind::primary), 1u);
    EXPECT_EQ(tracer.counts().of(RayKind::reflection), 7u);
}

TEST(PathWays, LogASegmentAsTheChildOfTheOneBefore) {
    const PathBench bench(large_lamp());
    Tracer tracer(bench.accelerator());
    RayLog log;
    tracer.record(&log);
    PathTracer paths(bench.scene(), bench.lights(), {.roulette = false, .depth = 3}, Needs(),
                     tracer);
    static_cast<void>(paths.radiance(testing::ray_to({-0.6, 1.2, -3}, {1.7, 0, 0.2}), {Key(4), 0}));
    int previous = LoggedRay::no_parent, shadows = 0, bounces = 0;
    for (std::size_t i = 0; i < log.rays().size(); ++i) {
        const LoggedRay& ray = log.rays()[i];
        EXPECT_EQ(ray.parent, previous) << i;
        shadows += ray.kind == RayKind::shadow;
        bounces += ray.kind == RayKind::gi;
        if (ray.kind != RayKind::shadow) previous = static_cast<int>(i);
    }
    EXPECT_GE(shadows, 1);
    EXPECT_GE(bounces, 1);
}

}  // namespace
}  // namespace luch
