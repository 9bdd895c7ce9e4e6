#include "framework/baseline/classic.h"
#include "framework/technique/catalogue.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <numeric>

namespace luch::path {
TechniqueInfo describe();
}

namespace luch {
namespace {

using testing::OwnStudio;

/// A floor, a wall and a ball under a lamp that is not in the picture; 12 × 9 pixels.
Scene lamp_lit() {
    Scene scene = testing::empty_scene();
    scene.lights.clear();
    scene.settings.frame = {12, 9};
    scene.settings.max_depth = 3;
    scene.camera.position = {0, 1, -4};
    testing::add(scene, Plane{}, Lambert{.color = {0.7f, 0.6f, 0.5f}});
    testing::add(scene, Plane{.limit = 5}, Lambert{.color = {0.2f, 0.7f, 0.3f}},
                 Transform::rotation(0, std::acos(0), 0).then(Transform::translation({0, 0, 2})));
    testing::add(scene, Sphere{.centre = {0.5, 0.7, 0}, .radius = 0.7}, Phong{.exponent = 20});
    add_rect_light(scene, "lamp",
                   RectLight{.to_world = Transform::translation({-1, 4.2, -1}), .power = 40});
    return scene;
}

Outcome rendered(const OwnStudio& studio, int spp, std::uint64_t seed,
                 const std::string& param = "mis=on") {
    Shot shot = shot_of(studio.scene());
    shot.spp = spp;
    shot.seed = seed;
    const auto technique = path::describe().create();
    set_param(*technique, param);
    return studio.render(*technique, shot);
}

double rmse(const Image<Rgb>& a, const Image<Rgb>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const Rgb off = a.pixels()[i] - b.pixels()[i];
        sum += glm::dot(off, off) / 3;
    }
    return std::sqrt(sum / static_cast<double>(a.pixels().size()));
}

/// Least squares through (log x, log y).
double slope(const std::vector<double>& x, const std::vector<double>& y) {
    double mx = 0, my = 0, xy = 0, xx = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mx += std::log(x[i]) / static_cast<double>(x.size());
        my += std::log(y[i]) / static_cast<double>(x.size());
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xy += (std::log(x[i]) - mx) * (std::log(y[i]) - my);
        xx += (std::log(x[i]) - mx) * (std::log(x[i]) - mx);
    }
    return xy / xx;
}

TEST(Path, ErrsByTheSquareRootOfItsSamplesAndKnowsByHowMuch) {
    const OwnStudio studio(lamp_lit());
    const Image<Rgb> truth = rendered(studio, 4096, 99).frame.colour;
    std::vector<double> samples, errors;
    for (const int spp : {4, 16, 64, 256}) {
        double square = 0, claimed = 0;
        constexpr int seeds = 4;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            const Outcome outcome = rendered(studio, spp, seed);
            square += std::pow(rmse(outcome.frame.colour, truth), 2) / seeds;
            const auto& error = testing::plane_of<Rgb>(outcome, "standard error");
            claimed += std::pow(rmse(error, Image<Rgb>(error.size())), 2) / seeds;
        }
        samples.push_back(spp);
        errors.push_back(std::sqrt(square));
        EXPECT_NEAR(std::sqrt(claimed / square), 1, spp < 16 ? 0.4 : 0.2) << spp;
    }
    EXPECT_NEAR(slope(samples, errors), -0.5, 0.1);
}

TEST(Path, KnowsTheErrorOfEveryPixel) {
    const OwnStudio studio(lamp_lit());
    const Image<Rgb> truth = rendered(studio, 4096, 99).frame.colour;
    double sum = 0, square = 0;
    int count = 0;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const Outcome outcome = rendered(studio, 256, seed);
        const auto& error = testing::plane_of<Rgb>(outcome, "standard error");
        for (std::size_t i = 0; i < error.pixels().size(); ++i) {
            const double sigma = error.pixels()[i].g;
            if (!(sigma > 0)) continue;
            const double z = (outcome.frame.colour.pixels()[i].g - truth.pixels()[i].g) / sigma;
            sum += z;
            square += z * z;
            ++count;
        }
    }
    ASSERT_GT(count, 350);
    // Student's t of 16 groups has a variance of 15/13.
    EXPECT_NEAR(sum / count, 0, 0.2);
    EXPECT_NEAR(square / count, 15.0 / 13, 0.25);
}

TEST(Path, KnowsNothingOfTheErrorOfOneSample) {
    const OwnStudio studio(lamp_lit());
    const Outcome outcome = rendered(studio, 1, 0);
    const auto& error = testing::plane_of<Rgb>(outcome, "standard error");
    EXPECT_EQ(error(5, 5), Rgb(std::numeric_limits<float>::infinity()));
    EXPECT_EQ(outcome.non_finite.count, 0u);
}

TEST(Path, TakesAsManySamplesAsSceneOrLensAskFor) {
    Scene scene = lamp_lit();
    scene.settings.paths = 5;
    scene.camera.lens_samples = 9;
    const auto primary = [](const Scene& asked) {
        const OwnStudio studio(asked);
        return rendered(studio, 0, 0).counts.of(RayKind::primary);
    };
    EXPECT_EQ(primary(scene), 12u * 9 * 5);
    scene.camera.depth_of_field = true;
    EXPECT_EQ(primary(scene), 12u * 9 * 9);
}

TEST(Path, IsTheSameOnAnyNumberOfThreads) {
    const Outcome one = rendered(OwnStudio(testing::bit_of_everything(), 1), 9, 3);
    for (const int threads : {2, 16}) {
        const Outcome many = rendered(OwnStudio(testing::bit_of_everything(), threads), 9, 3);
        EXPECT_EQ(testing::different_pixels(one, many), 0u);
        EXPECT_EQ(testing::plane_of<Rgb>(one, "standard error"),
                  testing::plane_of<Rgb>(many, "standard error"));
    }
}

TEST(Path, SamplesNothingThatASceneHasNot) {
    const Scene scene = lamp_lit();
    const Plan plan = path::describe().create()->plan(scene, shot_of(scene));
    EXPECT_TRUE(plan.needed("placed lights"));
    EXPECT_FALSE(plan.needed("distant lights"));
    EXPECT_FALSE(plan.needed("sky"));
    EXPECT_FALSE(plan.needed("lens"));
}

/// What a file may ask for, and no number survives unguarded.
std::vector<std::pair<std::string, Scene>> extremes() {
    std::vector<std::pair<std::string, Scene>> cases;
    const auto add = [&](const std::string& name, const auto& change) {
        Scene scene = lamp_lit();
        change(scene);
        cases.emplace_back(name, std::move(scene));
    };
    const auto floor_of = [&](const std::string& name, const Material& material) {
        add(name, [&](Scene& scene) { scene.materials[scene.nodes[0].material] = material; });
    };
    add("power 1e30", [](Scene& scene) {
        scene.lights.clear();
        scene.nodes.pop_back();
        add_rect_light(
            scene, "lamp",
            RectLight{.to_world =
                          Transform::scaling(Vec3d(1e-6)).then(Transform::translation({-1, 3, -1})),
                      .power = 1e30f});
        scene.lights.emplace_back(PointLight{.position = {0, 1e-9, 0}, .power = 1e30f});
        scene.lights.emplace_back(DirectionalLight{.power = 1e30f});
    });
    add("black", [](Scene& scene) {
        for (Material& material : scene.materials) material = Lambert{.color = Rgb(0)};
    });
    add("no lights", [](Scene& scene) {
        scene.lights.clear();
        scene.nodes.pop_back();
    });
    add("colour 1e-30", [](Scene& scene) {
        scene.lights.emplace_back(PointLight{.color = Rgb(1e-30f), .power = 1e-30f});
    });
    add("a lamp within a surface", [](Scene& scene) {
        scene.lights.emplace_back(PointLight{.position = {0, 0, 0}, .power = 5});
        add_rect_light(scene, "flat", RectLight{.to_world = {}, .power = 3});
    });
    add("mirrors face to face", [](Scene& scene) {
        scene.settings.max_depth = 200;
        for (int i : {0, 1}) scene.materials[scene.nodes[i].material] = Reflection{};
        testing::add(scene, Plane{.y = 3.5}, Reflection{.multiplier = Rgb(1)});
    });
    for (const double ior : {1.0, 1e-6, 10.0}) {
        floor_of("ior " + std::to_string(ior), Refraction{.ior = ior, .absorption = 1e6});
    }
    floor_of("exponent 1e6", Phong{.color = Rgb(0.2f), .exponent = 1e6});
    floor_of("glossiness near 1", Reflection{.glossiness = 1 - 1e-7});
    floor_of("glossiness 0", Reflection{.glossiness = 0});
    floor_of("albedo 3", Lambert{.color = Rgb(3)});
    floor_of("albedo 1e30", Lambert{.color = Rgb(1e30f)});
    floor_of("a negative albedo", Lambert{.color = {-1, 0.5f, 2}});
    floor_of("specular 1e6", Phong{.color = Rgb(2), .specular = Rgb(1e6f)});
    floor_of("no layers", Layered{});
    return cases;
}

TEST(Path, StaysFiniteInExtremes) {
    for (const auto& [name, scene] : extremes()) {
        const OwnStudio studio(scene);
        for (const char* param : {"mis=on", "mis=off", "sampling=light", "sampling=bsdf"}) {
            const Outcome outcome = rendered(studio, 4, 1, param);
            EXPECT_EQ(outcome.non_finite.count, 0u)
                << name << " " << param << " at " << outcome.non_finite.first_x << " "
                << outcome.non_finite.first_y;
            const auto& error = testing::plane_of<Rgb>(outcome, "standard error").pixels();
            EXPECT_TRUE(std::all_of(error.begin(), error.end(), all_finite<Rgb>)) << name;
        }
    }
}

TEST(Path, CountsATexelThatIsNotANumberAndSpreadsItNoFurther) {
    Scene scene = testing::empty_scene();
    scene.settings.frame = {8, 6};
    scene.materials.emplace_back(Lambert{.color = Rgb(std::numeric_limits<float>::quiet_NaN())});
    scene.geometries.emplace_back(Sphere{.centre = {0, 0, 5}, .radius = 1});
    add_node(scene, "ball", 0, 0, {});
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio, 4, 1);
    EXPECT_GT(outcome.non_finite.count, 0u);
    EXPECT_LT(outcome.non_finite.count, 20u);
}

}  // namespace
}  // namespace luch
