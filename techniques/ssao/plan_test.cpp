// What the technique leaves out, and that it does no harm.
#include "techniques/ssao/plan.h"

#include "framework/technique/catalogue.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch::techniques::ssao {
namespace {

using testing::different_pixels;
using ::testing::HasSubstr;
using testing::OwnStudio;
using testing::plane_of;

constexpr const char* modes[] = {"mode=bitmask", "mode=gtao", "mode=classic", "mode=rays"};

std::unique_ptr<Technique> technique_of(const std::vector<std::string>& params) {
    std::unique_ptr<Technique> technique = make(reference(), {.samples = 36});
    for (const std::string& param : params) set_param(*technique, param);
    return technique;
}

Outcome rendered(const OwnStudio& studio, const std::vector<std::string>& params,
                 const Budget& budget = {}) {
    return studio.render(*technique_of(params), budget);
}

const Stage& stage_of(const Plan& plan, std::string_view name) {
    const auto found = std::ranges::find(plan.stages, name, &Stage::name);
    EXPECT_NE(found, plan.stages.end());
    return *found;
}

Plan plan_for(const Scene& scene, const std::vector<std::string>& params = {}) {
    return technique_of(params)->plan(scene, shot_of(scene));
}

/// One thing in ambient light.
Scene one(const Geometry& geometry, const Transform& to_world = {}) {
    Scene scene = testing::empty_scene();
    scene.settings.ambient_light = Rgb(0.5f);
    testing::add_shape(scene, geometry, to_world);
    return scene;
}

const Transform ahead = Transform::scaling({1, 2, 0.7})
                            .then(Transform::rotation(0.3, 0.7, 1))
                            .then(Transform::translation({0.4, 0.2, 4}));

TEST(SsaoPlan, IsTheBaselineBitForBitWithoutAmbientLight) {
    Scene scene = testing::one_of_each();
    scene.settings.ambient_light = Rgb(0);
    scene.settings.anti_aliasing = true;
    EXPECT_FALSE(stage_of(plan_for(scene), stage::occlusion).needed);
    EXPECT_EQ(stage_of(plan_for(scene), stage::occlusion).kind, Stage::exact);
    const OwnStudio studio(std::move(scene));
    const Shot shot = shot_of(studio.scene());
    const Outcome expected = studio.render(*baseline::describe().create(), shot);
    for (const char* mode : modes) {
        for (const bool skip : {true, false}) {
            Budget budget;
            budget.skip = skip;
            const Outcome outcome = studio.render(*technique_of({mode}), shot, budget);
            EXPECT_EQ(different_pixels(outcome, expected), 0u) << mode << skip;
            EXPECT_EQ(outcome.counts.of(RayKind::gi) > 0, !skip && mode == modes[3]);
        }
    }
}

TEST(SsaoPlan, NeedsNoPassWhereAmbientLightShinesOnNothing) {
    Scene scene = testing::one_of_each();
    for (Material& material : scene.materials) material = Const{Rgb(0.3f, 0.6f, 0.9f)};
    EXPECT_FALSE(stage_of(plan_for(scene), stage::occlusion).needed);
    EXPECT_TRUE(stage_of(plan_for(scene, {"show=visibility"}), stage::occlusion).needed);
    const OwnStudio studio(std::move(scene));
    for (const char* mode : modes) {
        EXPECT_EQ(different_pixels(rendered(studio, {mode}),
                                   rendered(studio, {mode}, {.forced = {"occlusion"}})),
                  0u);
    }
}

TEST(SsaoPlan, LeavesOutWhatOneConvexThingHidesOfItselfWithoutChangingABit) {
    for (const Geometry& geometry :
         {Geometry(Sphere{}), Geometry(Cube{.side = 1.5}), Geometry(Plane{.limit = 2}),
          Geometry(testing::mesh_of({{-1, -1, 0}, {1, -1, 0.5}, {0, 1, 0}}, {0, 1, 2}))}) {
        Scene scene = one(geometry, ahead);
        EXPECT_FALSE(stage_of(plan_for(scene), stage::convex).needed);
        EXPECT_EQ(stage_of(plan_for(scene), stage::convex).kind, Stage::exact);
        EXPECT_EQ(stage_of(plan_for(scene, {"normals=picture"}), stage::convex).kind,
                  Stage::heuristic);
        const OwnStudio studio(std::move(scene));
        for (const char* mode : modes) {
            const Outcome without = rendered(studio, {mode, "radius=0.7"});
            const Outcome with =
                rendered(studio, {mode, "radius=0.7"}, {.forced = {"convex things"}});
            EXPECT_EQ(different_pixels(without, with), 0u) << mode << geometry.index();
            EXPECT_GT(stage_of(with.plan, stage::occlusion).work, 0u) << "it was at work";
            EXPECT_EQ(stage_of(without.plan, stage::occlusion).work, 0u);
        }
    }
}

TEST(SsaoPlan, KeepsThePassInsideOfAThingAndForTwoThings) {
    Scene inside = one(Sphere{.radius = 9});
    EXPECT_TRUE(stage_of(plan_for(inside), stage::convex).needed);
    Scene cube = one(Cube{.side = 9});
    EXPECT_TRUE(stage_of(plan_for(cube), stage::convex).needed);
    const OwnStudio studio(std::move(inside));
    const Outcome dark = rendered(studio, {"mode=rays", "radius=20"});
    for (const float visible : plane_of<float>(dark, "visibility").pixels()) EXPECT_EQ(visible, 0);
    Scene two = one(Sphere{}, ahead);
    testing::add_shape(two, Plane{.y = -3});
    EXPECT_TRUE(stage_of(plan_for(two), stage::convex).needed);
}

/// A floor that meets a wall.
Scene corner() {
    Scene scene = one(Plane{.y = -1, .limit = 20});
    testing::add_shape(scene, Cube{.centre = {0, 0, 15}, .side = 20});
    scene.camera.position = {0, 0, -1};
    return scene;
}

TEST(SsaoPlan, LeavesOutARadiusBelowAPixelWithinItsBound) {
    Scene scene = testing::empty_scene();
    scene.settings.ambient_light = Rgb(1);
    scene.lights.clear();
    testing::add_shape(scene, Cube{.centre = {0, -50, 60}, .side = 98}, {}, Rgb(1));
    testing::add_shape(scene, Cube{.side = 10},
                       Transform::rotation(0.5, 0, 0).then(Transform::translation({3, 0, 22})),
                       Rgb(1));
    const std::vector<std::string> small{"radius=0.05"};
    const Stage stage = stage_of(plan_for(scene, small), stage::small);
    EXPECT_FALSE(stage.needed);
    EXPECT_EQ(stage.kind, Stage::bounded);
    EXPECT_EQ(stage.bound, 1);
    const OwnStudio studio(std::move(scene));
    const Outcome without = rendered(studio, small);
    EXPECT_EQ(different_pixels(without, rendered(studio, small, {.forced = {"small radius"}})), 0u);
    // Against the truth: only pixels next to an edge between two surfaces lose light.
    const Outcome truth = rendered(studio, {"mode=rays", "radius=0.05"});
    const auto& visible = plane_of<float>(truth, "visibility");
    const auto& normal = plane_of<Rgb>(without, "normal");
    int lost = 0;
    for (int y = 1; y + 1 < visible.height(); ++y) {
        for (int x = 1; x + 1 < visible.width(); ++x) {
            if (visible(x, y) == 1) continue;
            ++lost;
            bool edge = false;
            for (const auto& [i, j] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
                edge |= normal(x + i, y + j) != normal(x, y);
            }
            EXPECT_TRUE(edge) << x << "," << y;
        }
    }
    EXPECT_GT(lost, 0) << "the bound is met by something";
}

TEST(SsaoPlan, KeepsTheRadiusOfAPixelAndMore) {
    EXPECT_TRUE(stage_of(plan_for(corner(), {"radius=0.5"}), stage::small).needed);
    EXPECT_THAT(stage_of(plan_for(corner(), {"radius=0.5"}), stage::small).why, HasSubstr("px"));
}

TEST(SsaoPlan, TakesTheRadiusFromTheSceneWhereNoneIsGiven) {
    Scene scene = one(Plane{});
    EXPECT_EQ(settled({}, scene).radius, 1);
    testing::add_shape(scene, Cube{.side = 4});
    EXPECT_NEAR(settled({}, scene).radius, std::sqrt(3.0), 1e-9);
    EXPECT_EQ(settled({.radius = 7}, scene).radius, 7);
}

TEST(SsaoPlan, IsNotForOtherProjectionsAndLenses) {
    for (const Projection projection :
         {Projection::fisheye, Projection::spherical, Projection::orthographic}) {
        Scene scene = testing::one_of_each();
        scene.camera.projection = projection;
        EXPECT_FALSE(plan_for(scene).applies);
        EXPECT_THAT(plan_for(scene).why, HasSubstr("not perspective"));
        EXPECT_TRUE(plan_for(scene, {"mode=rays"}).applies);
    }
    Scene scene = testing::one_of_each();
    scene.camera.depth_of_field = true;
    EXPECT_FALSE(plan_for(scene).applies);
    EXPECT_THAT(plan_for(scene).why, HasSubstr("lens"));
    EXPECT_TRUE(plan_for(scene, {"mode=rays"}).applies);
}

}  // namespace
}  // namespace luch::techniques::ssao
