#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"
#include "tests/trace/path_estimate.h"

#include <gtest/gtest.h>

#include <numbers>

namespace luch {
namespace {

using testing::PathBench;
constexpr double pi = std::numbers::pi;

/// Irradiance on a surface from a parallelogram of radiance 1 that lies above its horizon: half the
/// sum of the angles of its edges, each times its plane's normal (Lambert 1760; Baum, Rushmeier and
/// Winget, "Improving Radiosity Solutions Through the Use of Analytically Determined Form-Factors",
/// 1989).
double irradiance(const RectLight& light, const Vec3d& point, const Vec3d& normal) {
    const Vec3d corners[] = {{-0.5, 0, -0.5}, {0.5, 0, -0.5}, {0.5, 0, 0.5}, {-0.5, 0, 0.5}};
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        const Vec3d a = glm::normalize(light.to_world.point(corners[i]) - point);
        const Vec3d b = glm::normalize(light.to_world.point(corners[(i + 1) % 4]) - point);
        const double angle = std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
        sum += angle * glm::dot(glm::normalize(glm::cross(a, b)), normal);
    }
    return std::abs(sum) / 2;
}

struct Lamp {
    const char* name;
    Transform to_world;
};

std::vector<Lamp> lamps() {
    const auto at = [](const Vec3d& size, double pitch, double roll, const Vec3d& place) {
        return Transform::scaling(size)
            .then(Transform::rotation(0.4, pitch, roll))
            .then(Transform::translation(place));
    };
    const Transform sheared{glm::dmat3(2, 0, 0.9, 0, 1, 0, 0.4, 0, 1), {0.5, 2, 0.2}};
    return {{"above", at({1, 1, 1}, 0, 0, {0, 2, 0})},
            {"aside", at({2, 1, 0.5}, 0, 0, {3, 1, 1})},
            {"tilted", at({1, 1, 1}, 0.6, 0.3, {-0.5, 2, 1})},
            {"near", at({2, 1, 3}, 0, 0, {0.2, 0.05, 0.1})},
            {"tiny", at(Vec3d(1e-3), 0.2, 0, {0.3, 5, 0})},
            {"mirrored", at({-1, 1, 2}, 0.3, 0.2, {0, 3, 0})},
            {"sheared", sheared}};
}

TEST(PathLights, LightAFloorFromARectangleByItsClosedForm) {
    for (const auto& [name, to_world] : lamps()) {
        Scene scene = testing::dark_scene();
        const RectLight light{.to_world = to_world, .color = {1, 0.5f, 0.25f}, .power = 3};
        add_rect_light(scene, "lamp", light);
        testing::add(scene, Plane{}, Lambert{.color = Rgb(1)});
        const PathBench bench(std::move(scene));
        const Vec3d radiance = bench.lights().rect(0).radiance();
        const Vec3d truth = radiance * irradiance(light, {0, 0, 0}, {0, 1, 0}) / pi;
        // Below all of the lamps, and straight at the origin.
        const Ray ray = testing::ray_to({-4, 0.02, 0}, {0, 0, 0});
        for (const auto& [way, settings] : testing::all_ways(0)) {
            const auto seen = bench.measured(ray, settings, 4000);
            // By chance a path never meets the tiny one.
            const bool by_chance = settings.sampling == PathSampling::bsdf || !settings.mis;
            if (name == std::string("tiny") && by_chance) continue;
            EXPECT_LE(seen.sigmas_from(truth), 3) << name << " " << way;
            if (settings.sampling != PathSampling::light) continue;
            EXPECT_LE(seen.error.x, 0.02 * truth.x) << name;
        }
    }
}

TEST(PathLights, ShowTheirFaceToTheCameraAndInMirrorsInFull) {
    Scene scene = testing::dark_scene();
    const Transform high = Transform::translation({0, 2, 0});
    add_rect_light(scene, "lamp", RectLight{.to_world = high, .color = Rgb(1), .power = 3});
    testing::add(scene, Plane{}, Reflection{.multiplier = Rgb(0.5f)});
    const PathBench bench(std::move(scene));
    for (const auto& [name, settings] : testing::all_ways(3)) {
        const auto face = bench.measured({{0, 1, 0}, {0, 1, 0}}, settings, 2);
        const auto mirrored = bench.measured({{0, 1, 0}, {0, -1, 0}}, settings, 2);
        const auto behind = bench.measured({{0, 3, 0}, {0, -1, 0}}, settings, 2);
        EXPECT_NEAR(face.mean.x, 3, 1e-6) << name;
        EXPECT_NEAR(mirrored.mean.x, 1.5, 1e-6) << name;
        EXPECT_EQ(behind.mean.x, 0) << name;
    }
}

TEST(PathLights, LightAFloorFromPointsSpotsAndAfarByTheirFormulas) {
    Scene scene = testing::dark_scene();
    scene.lights.emplace_back(PointLight{.position = {0, 2, 0}, .color = Rgb(1), .power = 8});
    scene.lights.emplace_back(SpotLight{.position = {0, 4, 0},
                                        .inner_cosine = 0.9,
                                        .outer_cosine = 0.8,
                                        .color = Rgb(1),
                                        .power = 16});
    scene.lights.emplace_back(SpotLight{.position = {4, 4, 0}, .outer_cosine = 0.9, .power = 50});
    scene.lights.emplace_back(DirectionalLight{.color = {1, 0.5f, 0}, .power = 2});
    scene.lights.emplace_back(DirectionalLight{.color = {0, 0.5f, 1}, .power = 4});
    testing::add(scene, Plane{}, Lambert{.color = Rgb(0.5f)});
    const PathBench bench(std::move(scene));
    const Vec3d truth = (Vec3d(8 / 4.0 + 16 / 16.0) + Vec3d(2, 3, 4)) * 0.5 / pi;
    for (const auto& [name, settings] : testing::all_ways(0)) {
        const auto seen = bench.measured(testing::ray_to({-1, 1, 0}, {0, 0, 0}), settings, 2000);
        EXPECT_LE(seen.sigmas_from(truth), 3) << name;
        EXPECT_LT(seen.error.x, 0.05) << name;
    }
}

/// Lamps of many strengths over a floor, mostly far from any one place of it.
Scene thousand_lamps() {
    Scene scene = testing::dark_scene();
    for (int i = 0; i < 1000; ++i) {
        const Key key = Key(5).branch(static_cast<unsigned>(i));
        const Vec3d place{40 * key.uniform(0) - 20, 0.2 + key.uniform(1), 40 * key.uniform(2) - 20};
        scene.lights.emplace_back(PointLight{
            .position = place, .color = Rgb(1), .power = static_cast<float>(key.uniform(3))});
    }
    testing::add(scene, Plane{}, Lambert{.color = Rgb(1)});
    return scene;
}

TEST(PathLights, OfAThousandTakeTheNearOnesMoreOften) {
    const PathBench bench(thousand_lamps());
    const auto& lights = bench.scene().lights;
    for (const Vec3d& point : {Vec3d(0, 0, 0), Vec3d(7, 0, -11)}) {
        double truth = 0, square = 0;
        for (const Light& light : lights) {
            const auto& lamp = std::get<PointLight>(light);
            const Vec3d way = lamp.position - point;
            const double d = glm::length(way);
            const double arrives = lamp.power / (d * d) * way.y / d / pi;
            truth += arrives;
            square += arrives * arrives;
        }
        const auto count = static_cast<double>(lights.size());
        const double blind = std::sqrt(count * square - truth * truth);
        constexpr int samples = 4000;
        const auto seen = bench.measured(testing::ray_to(point + Vec3d(0, 0.1, -0.01), point),
                                         {.depth = 0}, samples);
        EXPECT_LE(seen.sigmas_from(Vec3d(truth)), 3);
        EXPECT_LT(seen.error.x * std::sqrt(samples), blind / 3);
    }
}

TEST(LightTree, ChoosesEveryLightAsOftenAsItSays) {
    Scene scene = thousand_lamps();
    scene.lights.resize(37);
    scene.lights.emplace_back(DirectionalLight{});
    scene.lights.emplace_back(PointLight{.position = {0, -3, 0}, .power = 100});
    const LightTree tree(scene.lights);
    const Vec3d point{1, 0, 2}, normal{0, 1, 0};
    std::vector<int> found(scene.lights.size());
    constexpr int tries = 100000;
    for (int i = 0; i < tries; ++i) {
        const auto choice = tree.choose(point, normal, (i + 0.5) / tries);
        ASSERT_TRUE(choice.has_value());
        ++found[choice->light];
        ASSERT_NEAR(choice->probability, tree.probability(choice->light, point, normal), 1e-12);
    }
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        EXPECT_NEAR(found[i], tries * tree.probability(i, point, normal), 2) << i;
    }
    EXPECT_EQ(found[37], 0);  // has no place
    EXPECT_EQ(found[38], 0);  // below the horizon
}

TEST(SkySampler, FindsEveryDirectionThatSendsLightAsOftenAsItSays) {
    Scene scene = testing::dark_scene();
    CubemapEnvironment sky;
    const Size sizes[] = {{9, 9}, {1, 1}, {16, 4}, {2, 2}, {0, 0}, {700, 3}};
    for (std::size_t side = 0; side < 6; ++side) {
        sky.sides[side] = Image<Rgb>(sizes[side], Rgb(0));
        int i = 0;
        for (Rgb& pixel : sky.sides[side].pixels()) {
            if (Key(side).branch(static_cast<unsigned>(++i)).uniform(0) < 0.3) pixel = {0, 0.5f, 2};
        }
    }
    scene.environment = std::move(sky);
    const SkySampler sampler(scene);
    const Vec3d up{0, 1, 0};
    constexpr int tries = 200000;
    double covered = 0, light = 0, sampled_light = 0;
    for (int i = 0; i < tries; ++i) {
        const Key key = Key(9).branch(static_cast<unsigned>(i));
        const double z = 2 * key.uniform(0) - 1, turn = 2 * pi * key.uniform(1);
        const double r = std::sqrt(1 - z * z);
        const Vec3d direction{r * std::cos(turn), r * std::sin(turn), z};
        const double pdf = sampler.pdf(up, direction);
        const float blue = sky_radiance(scene, direction).b;
        ASSERT_TRUE(pdf > 0 || blue == 0) << i;
        covered += pdf * 4 * pi / tries;
        light += blue * 4 * pi / tries;
        const auto sample = sampler.sample(up, key.square(2));
        ASSERT_NEAR(sample.pdf, sampler.pdf(up, sample.direction), 1e-6 * sample.pdf);
        sampled_light += sky_radiance(scene, sample.direction).b / sample.pdf / tries;
    }
    EXPECT_NEAR(covered, 1, 0.02);
    EXPECT_NEAR(sampled_light, light, 0.02 * light);
}

}  // namespace
}  // namespace luch
