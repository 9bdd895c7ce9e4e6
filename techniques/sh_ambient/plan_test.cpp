// What the technique leaves out, and that it does no harm.
#include "techniques/sh_ambient/plan.h"

#include "techniques/sh_ambient/ringing.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <numbers>

namespace luch::techniques::sh_ambient {
namespace {

using testing::different_pixels;
using ::testing::HasSubstr;
using testing::OwnStudio;

Params with(Mode mode) {
    return {.mode = static_cast<int>(mode), .samples = 16, .probes = 3, .rays = 16, .bounces = 1};
}

/// A sky that is a function of the direction, at its texels.
CubemapEnvironment sky_of(int side, const std::function<double(const Vec3d&)>& grey) {
    CubemapEnvironment sky;
    for (std::size_t i = 0; i < 6; ++i) {
        sky.sides[i] = Image<Rgb>({side, side});
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const CubePoint at{static_cast<CubePoint::Side>(i), 2.0 * x / (side - 1) - 1,
                                   2.0 * y / (side - 1) - 1};
                sky.sides[i](x, y) = Rgb(static_cast<float>(grey(glm::normalize(at.direction()))));
            }
        }
    }
    return sky;
}

Scene under(std::optional<Environment> sky) {
    Scene scene = testing::sixty_spheres();
    scene.settings.frame = {32, 24};
    scene.environment = std::move(sky);
    return scene;
}

Scene black() {
    return under(std::nullopt);
}

Scene unlit() {
    Scene scene = under(ConstantEnvironment{Rgb(1)});
    for (Material& material : scene.materials) material = Reflection{};
    return scene;
}

Scene lightless() {
    Scene scene = black();
    scene.lights.clear();
    return scene;
}

Outcome rendered(const Scene& scene, const Params& params, const Budget& budget = {}) {
    return OwnStudio(scene).render(*make(reference(), params), budget);
}

Plan plan_for(const Scene& scene, const Params& params) {
    return make(reference(), params)->plan(scene, shot_of(scene));
}

const Stage& stage_of(const Plan& plan, std::string_view name) {
    return *std::ranges::find(plan.stages, name, &Stage::name);
}

TEST(ShPlan, LosesNoBitByLeavingOutWhatIsExact) {
    const std::vector<Scene> scenes{black(),
                                    unlit(),
                                    lightless(),
                                    under(ConstantEnvironment{{0.2f, 0.4f, 0.9f}}),
                                    under(sky_of(5, [](const Vec3d& d) { return 1 + d.x * d.y; })),
                                    testing::bit_of_everything()};
    for (const Scene& scene : scenes) {
        for (const Mode mode : {Mode::environment, Mode::probes, Mode::sampled, Mode::traced}) {
            const Outcome planned = rendered(scene, with(mode));
            Budget all;
            for (const Stage& stage : planned.plan.stages) {
                if (stage.needed || stage.kind != Stage::exact) continue;
                all.forced.push_back(stage.name);
                EXPECT_EQ(different_pixels(planned,
                                           rendered(scene, with(mode), {.forced = {stage.name}})),
                          0u)
                    << stage.name << " " << static_cast<int>(mode);
            }
            EXPECT_EQ(different_pixels(planned, rendered(scene, with(mode), all)), 0u);
        }
    }
}

TEST(ShPlan, TakesOneCoefficientOfAConstantSky) {
    for (const Scene& scene : {under(ConstantEnvironment{Rgb(0.5f)}), black()}) {
        const Plan plan = plan_for(scene, with(Mode::environment));
        for (const std::string_view terms : {stage::linear, stage::quadratic}) {
            EXPECT_FALSE(plan.needed(terms));
            EXPECT_EQ(stage_of(plan, terms).kind, Stage::exact);
        }
        EXPECT_EQ(degree_left(plan, with(Mode::environment)), 0);
    }
}

/// By how much a picture changes when a stage is forced on.
double change_by(const Scene& scene, std::string_view stage) {
    const Params params = with(Mode::environment);
    const Outcome planned = rendered(scene, params);
    const Outcome forced = rendered(scene, params, {.forced = {std::string(stage)}});
    double most = 0;
    for (std::size_t i = 0; i < planned.frame.colour.pixels().size(); ++i) {
        most = std::max<double>(
            most, max_norm(planned.frame.colour.pixels()[i] - forced.frame.colour.pixels()[i]));
    }
    return most;
}

TEST(ShPlan, TakesFourCoefficientsOfALinearSkyAndKeepsTheBound) {
    // Texels of a linear function, bilinear in between, are not quite linear; nor is this one.
    const Scene scene =
        under(sky_of(33, [](const Vec3d& d) { return 1 + 0.6 * d.x + 0.003 * d.y * d.y; }));
    const Plan plan = plan_for(scene, with(Mode::environment));
    EXPECT_TRUE(plan.needed(stage::linear));
    EXPECT_FALSE(plan.needed(stage::quadratic));
    EXPECT_EQ(stage_of(plan, stage::quadratic).kind, Stage::bounded);
    EXPECT_EQ(degree_left(plan, with(Mode::environment)), 1);
    const double change = change_by(scene, stage::quadratic);
    EXPECT_GT(change, 0);
    // The mean irradiance is π, of which an albedo below 1 sends on 1/π.
    EXPECT_LE(change, stage_of(plan, stage::quadratic).bound * 1.001);
}

TEST(ShPlan, TakesOneCoefficientOfASkyThatIsNearlyConstant) {
    const Scene scene = under(sky_of(5, [](const Vec3d& d) { return 1 + 0.001 * d.z; }));
    const Plan plan = plan_for(scene, with(Mode::environment));
    EXPECT_EQ(stage_of(plan, stage::linear).kind, Stage::bounded);
    EXPECT_EQ(degree_left(plan, with(Mode::environment)), 0);
    EXPECT_GT(change_by(scene, stage::linear), 0);
    EXPECT_LE(change_by(scene, stage::linear), stage_of(plan, stage::linear).bound);
}

TEST(ShPlan, KeepsTermsThatMayBeSeen) {
    const Scene scene = under(sky_of(5, [](const Vec3d& d) { return 1 + 0.004 * d.z; }));
    EXPECT_TRUE(plan_for(scene, with(Mode::environment)).needed(stage::linear));
}

TEST(ShPlan, BoundsWhatTermsCanChangeByWhatTheyDo) {
    // The bound is met: degree 1 is all in one direction.
    const Scene scene = under(sky_of(65, [](const Vec3d& d) { return 1 + 0.5 * d.x; }));
    const SkyLight sky = sky_light_of(scene, reference());
    const Vec3 n(1, 0, 0);
    Rgb all, flat;
    reference().irradiance(tamed(sky.light, 1, Ringing::off), {&n, 1}, {&all, 1});
    reference().irradiance(tamed(sky.light, 0, Ringing::off), {&n, 1}, {&flat, 1});
    EXPECT_NEAR(sky.strength[1], (all.x - flat.x) / flat.x, 1e-5);
    EXPECT_NEAR(sky.strength[1], 1.0 / 3, 1e-3);
    EXPECT_DOUBLE_EQ(sky.strength[0], 1);
}

TEST(ShPlan, SaysWhetherRingingNeedsToBeMended) {
    CubemapEnvironment sun = sky_of(9, [](const Vec3d&) { return 0.0; });
    sun.sides[CubemapEnvironment::pos_y](4, 4) = Rgb(100);
    Params params = with(Mode::environment);
    const Plan plan = plan_for(under(sun), params);
    EXPECT_TRUE(plan.needed(stage::ringing));
    EXPECT_THAT(stage_of(plan, stage::ringing).why, HasSubstr("0.8"));
    EXPECT_FALSE(plan_for(under(sky_of(5, [](const Vec3d& d) { return 1 + 0.5 * d.x; })), params)
                     .needed(stage::ringing));
    params.ringing = static_cast<int>(Ringing::off);
    EXPECT_FALSE(plan_for(under(sun), params).needed(stage::ringing));
}

TEST(ShPlan, TellsOfTexelsThatAreNotFinite) {
    CubemapEnvironment sky = sky_of(5, [](const Vec3d& d) { return 1 + d.x; });
    EXPECT_FALSE(plan_for(under(sky), with(Mode::environment)).needed(stage::wild));
    sky.sides[0](2, 2) = sky.sides[1](0, 0) = Rgb(std::numeric_limits<float>::infinity());
    const Outcome outcome = rendered(under(sky), with(Mode::environment));
    EXPECT_EQ(stage_of(outcome.plan, stage::wild).work, 2u);
    EXPECT_EQ(outcome.non_finite.count, 0u) << "the camera looks the other way";
}

TEST(ShPlan, AsksForLightInsideWhereOnlySurfacesGlow) {
    Scene scene = lightless();
    EXPECT_FALSE(plan_for(scene, with(Mode::probes)).needed(stage::ambient));
    scene.materials[0] = Const{Rgb(1)};
    EXPECT_TRUE(plan_for(scene, with(Mode::probes)).needed(stage::ambient));
    EXPECT_FALSE(plan_for(scene, with(Mode::environment)).needed(stage::ambient));
}

}  // namespace
}  // namespace luch::techniques::sh_ambient
