// What the technique leaves out, and that it does no harm.
#include "techniques/shadow_map/plan.h"

#include "framework/technique/catalogue.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch::techniques::shadow_map {
namespace {

using testing::different_pixels;
using ::testing::HasSubstr;
using testing::OwnStudio;
using ::testing::StartsWith;

constexpr const char* modes[] = {"mode=classic", "mode=pcss",      "mode=vsm",
                                 "mode=msm",     "mode=heuristic", "mode=exact"};

std::unique_ptr<Technique> technique_with(const std::vector<std::string>& params) {
    std::unique_ptr<Technique> technique = make(reference());
    for (const std::string& param : params) set_param(*technique, param);
    return technique;
}

Outcome rendered(const OwnStudio& studio, const std::vector<std::string>& params = {},
                 const Budget& budget = {}) {
    return studio.render(*technique_with(params), budget);
}

Outcome truth_of(const OwnStudio& studio) {
    return studio.render(*baseline::describe().create());
}

Plan plan_for(const Scene& scene, const std::vector<std::string>& params = {}) {
    return technique_with(params)->plan(scene, shot_of(scene));
}

const Stage& stage_of(const Plan& plan, std::string_view name) {
    const auto found = std::ranges::find(plan.stages, name, &Stage::name);
    EXPECT_NE(found, plan.stages.end());
    return *found;
}

Budget forced(std::string_view stage) {
    Budget budget;
    budget.forced = {std::string(stage)};
    return budget;
}

/// The stage is left out, exactly, in every mode, and forcing it on changes no bit.
void expect_exact_without(const Scene& scene, std::string_view stage,
                          std::span<const char* const> in_modes = modes) {
    const OwnStudio studio(scene);
    for (const char* mode : in_modes) {
        EXPECT_FALSE(stage_of(plan_for(scene, {mode}), stage).needed) << mode;
        EXPECT_EQ(stage_of(plan_for(scene, {mode}), stage).kind, Stage::exact) << mode;
        const Outcome without = rendered(studio, {mode}),
                      with = rendered(studio, {mode}, forced(stage));
        EXPECT_EQ(different_pixels(without, with), 0u) << mode;
    }
}

Scene lone(Geometry geometry) {
    Scene scene = testing::empty_scene();
    scene.camera.position = {0, 3, 0};
    scene.camera.pitch_deg = -20;
    testing::add_shape(scene, std::move(geometry),
                       Transform::rotation(0.4, 0.3, 0.1).then(Transform::translation({0, 0, 6})));
    return scene;
}

TEST(ShadowMapPlan, MakesNoMapsWithoutCasters) {
    Scene scene = testing::empty_scene();
    expect_exact_without(scene, stage::maps);
    EXPECT_THAT(plan_for(scene).why, HasSubstr("nothing casts a shadow"));
}

TEST(ShadowMapPlan, MakesNoMapsWithoutReceivers) {
    Scene scene = lone(Sphere{.radius = 2});
    scene.materials[0] = Reflection{};
    expect_exact_without(scene, stage::maps);
    EXPECT_THAT(plan_for(scene).why, HasSubstr("light falls on nothing"));
}

TEST(ShadowMapPlan, LeavesLightsThatAreInfinitelyFarToRays) {
    Scene scene = testing::one_of_each();
    scene.lights[0] = DirectionalLight{.direction = glm::normalize(Vec3d(1, -3, 1))};
    expect_exact_without(scene, stage::maps);
    const OwnStudio studio(scene);
    EXPECT_EQ(different_pixels(rendered(studio), truth_of(studio)), 0u);
    scene.lights.emplace_back(PointLight{.position = {0, 10, -10}});
    EXPECT_THAT(stage_of(plan_for(scene), stage::maps).why,
                HasSubstr("1 lights are left to shadow rays"));
}

TEST(ShadowMapPlan, NeedsNoMapForALoneConvexThing) {
    constexpr const char* without_bleeding[] = {"mode=classic", "mode=pcss", "mode=heuristic",
                                                "mode=exact"};
    for (const Geometry& geometry : {Geometry(Sphere{.radius = 2}), Geometry(Cube{.side = 3})}) {
        const Scene scene = lone(geometry);
        expect_exact_without(scene, stage::convex, without_bleeding);
        const OwnStudio studio(scene);
        const Outcome outcome = rendered(studio);
        EXPECT_EQ(different_pixels(outcome, truth_of(studio)), 0u) << "n·l does it";
        EXPECT_EQ(outcome.counts.of(RayKind::shadow), 0u);
        EXPECT_EQ(stage_of(outcome.plan, stage::maps).work, 0u);
    }
    EXPECT_EQ(stage_of(plan_for(lone(Sphere{}), {"mode=vsm"}), stage::convex).kind,
              Stage::heuristic);
}

TEST(ShadowMapPlan, NeedsAMapForAThingThatTheLightIsInOrThatIsNotAlone) {
    Scene inside = lone(Cube{.side = 4});
    std::get<PointLight>(inside.lights[0]).position = {0, 0, 6};
    EXPECT_TRUE(stage_of(plan_for(inside), stage::convex).needed);
    Scene two = lone(Sphere{});
    testing::add_shape(two, Sphere{}, Transform::translation({3, 0, 6}));
    EXPECT_TRUE(stage_of(plan_for(two), stage::convex).needed);
    Scene bumped = lone(Sphere{});
    bumped.nodes[0].bump = 0;
    EXPECT_TRUE(stage_of(plan_for(bumped), stage::convex).needed);
    EXPECT_TRUE(stage_of(plan_for(lone(Plane{})), stage::convex).needed);
}

TEST(ShadowMapPlan, FillsNoFacesThroughWhichNothingReceivesLight) {
    Scene scene = testing::one_of_each();
    expect_exact_without(scene, stage::empty_faces);
    const OwnStudio studio(scene);
    const auto texels = [&](const Budget& budget) {
        return stage_of(rendered(studio, {"fit=off"}, budget).plan, stage::maps).work;
    };
    const std::uint64_t few = texels({}), all = texels(forced(stage::empty_faces));
    EXPECT_LT(few, all);
    Scene spot = lone(Cube{.side = 100});
    testing::add_shape(spot, Sphere{});
    spot.lights[0] = SpotLight{.position = {0, 0, 6},
                               .direction = {0, -1, 0},
                               .inner_cosine = 0.9,
                               .outer_cosine = 0.8,
                               .power = 10};
    const OwnStudio in_a_box(spot);
    EXPECT_LT(stage_of(rendered(in_a_box, {"fit=off"}).plan, stage::maps).work, 512u * 512u)
        << "a cone looks through one face";
}

/// A floor under a row of bars, close to the light and far from the camera.
Scene far_away() {
    Scene scene = testing::empty_scene();
    scene.camera.position = {0, 110, -110};
    scene.camera.pitch_deg = -45;
    scene.camera.fov_deg = 8;
    scene.lights[0] = PointLight{.position = {0.1, 4, -0.2}, .power = 60};
    testing::add_shape(scene, Cube{.side = 10}, Transform::translation({0, -5, 0}));
    for (int i = 0; i < 4; ++i) {
        testing::add_shape(scene, Cube{.side = 0.4},
                           Transform::translation({i - 1.5, 1.5, 0.3 * i}));
    }
    return scene;
}

TEST(ShadowMapPlan, FiltersNothingWhereTexelsAreNarrowerThanHalfAPixel) {
    const Scene scene = far_away();
    const OwnStudio studio(scene);
    const Stage& stage = stage_of(plan_for(scene, {"side=2048"}), stage::filter);
    EXPECT_FALSE(stage.needed);
    EXPECT_EQ(stage.kind, Stage::bounded);
    EXPECT_EQ(stage.bound, filtered_px);
    EXPECT_TRUE(stage_of(plan_for(scene, {"side=64"}), stage::filter).needed);
    // What differs lies within a texel and a half of a shadow's edge: less than a pixel from it.
    const Outcome without = rendered(studio, {"side=2048"});
    const Outcome with = rendered(studio, {"side=2048"}, forced(stage::filter));
    const Outcome truth = truth_of(studio);
    int differ = 0;
    const Size size = truth.frame.size();
    for (int y = 1; y < size.height - 1; ++y) {
        for (int x = 1; x < size.width - 1; ++x) {
            if (without.frame.colour(x, y) == with.frame.colour(x, y)) continue;
            ++differ;
            float least = 1e9f, most = 0;
            for (int k = 0; k < 9; ++k) {
                const float light = truth.frame.colour(x + k % 3 - 1, y + k / 3 - 1).g;
                least = std::min(least, light);
                most = std::max(most, light);
            }
            EXPECT_GT(most, 1.3f * least) << x << " " << y << ": no edge is near";
        }
    }
    EXPECT_GT(differ, 0);
    EXPECT_LT(differ, 2000);
}

TEST(ShadowMapPlan, IsTheSamePictureWithEverythingForcedOnThatIsExact) {
    const OwnStudio studio(testing::bit_of_everything());
    for (const char* mode : modes) {
        const Outcome planned = rendered(studio, {mode, "side=64"});
        Budget budget;
        for (const Stage& stage : planned.plan.stages) {
            if (stage.kind == Stage::exact) budget.forced.push_back(stage.name);
        }
        EXPECT_EQ(different_pixels(planned, rendered(studio, {mode, "side=64"}, budget)), 0u)
            << mode;
    }
}

TEST(ShadowMapPlan, SaysWhenItDoesNotPay) {
    Scene scene = testing::one_of_each();
    scene.settings.frame = {64, 48};
    EXPECT_THAT(plan_for(scene).why, StartsWith("does not pay by time: among 5 nodes"));
    Scene many = scene;
    for (int i = 0; i < 300; ++i) many.nodes.push_back(many.nodes[1]);
    EXPECT_THAT(plan_for(many).why, HasSubstr("pays after"));
    scene.nodes[1].moving = true;
    EXPECT_THAT(plan_for(scene).why, StartsWith("does not pay: things move"));
    EXPECT_THAT(plan_for(testing::empty_scene()).why, StartsWith("does not pay"));
}

}  // namespace
}  // namespace luch::techniques::shadow_map
