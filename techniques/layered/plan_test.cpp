// What the technique leaves out, and that it does no harm.
#include "techniques/layered/plan.h"

#include "framework/technique/catalogue.h"
#include "techniques/layered/planes.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch::techniques::layered {
namespace {

using testing::different_pixels;
using ::testing::HasSubstr;
using testing::OwnStudio;

constexpr const char* modes[] = {"mode=lens", "mode=discs", "mode=classic"};

Outcome rendered(const OwnStudio& studio, const char* mode, const Budget& budget = {}) {
    const std::unique_ptr<Technique> technique = make(reference(), Mode::lens);
    set_param(*technique, mode);
    return studio.render(*technique, budget);
}

Budget forced(std::string_view stage) {
    Budget budget;
    budget.forced = {std::string(stage)};
    return budget;
}

const Stage& stage_of(const Plan& plan, std::string_view name) {
    const auto found = std::ranges::find(plan.stages, name, &Stage::name);
    EXPECT_NE(found, plan.stages.end());
    return *found;
}

Plan plan_for(const Scene& scene) {
    return make(reference(), Mode::lens)->plan(scene, shot_of(scene));
}

void look_through_lens(Scene& scene, double focal_distance = 6) {
    scene.camera.depth_of_field = true;
    scene.camera.f_number = 16;
    scene.camera.focal_distance = focal_distance;
}

/// A checkered wall that fills the frame.
Scene wall(double depth) {
    Scene scene = testing::empty_scene();
    scene.settings.frame = {64, 48};
    testing::add_shape(
        scene, Plane{},
        Transform::rotation(0, -1.5707963267948966, 0).then(Transform::translation({0, 0, depth})));
    scene.textures.emplace_back(CheckerTexture{.scaling = 0.3});
    std::get<Lambert>(scene.materials.back()).texture = 0;
    look_through_lens(scene);
    return scene;
}

TEST(LayeredPlan, IsTheBaselineBitForBitWithoutALens) {
    Scene scene = testing::one_of_each();
    scene.settings.anti_aliasing = true;
    const OwnStudio studio(std::move(scene));
    for (const int spp : {0, 1, 5}) {
        Shot shot = shot_of(studio.scene());
        shot.spp = spp;
        const Outcome expected = studio.render(*baseline::describe().create(), shot);
        for (const bool skip : {true, false}) {
            Budget budget;
            budget.skip = skip;
            const auto technique = make(reference(), Mode::lens);
            const Outcome outcome = studio.render(*technique, shot, budget);
            EXPECT_EQ(different_pixels(outcome, expected), 0u) << spp << skip;
            EXPECT_EQ(stage_of(outcome.plan, stage::blur).needed, !skip);
        }
    }
}

TEST(LayeredPlan, LeavesTheBlurOutWhereAllIsInFocusWithoutChangingABit) {
    Scene scene = testing::empty_scene();
    scene.settings.background = {0.2f, 0.4f, 0.1f};
    scene.geometries.emplace_back(Plane{.limit = 3});
    scene.materials.emplace_back(Const{Rgb(0.9f, 0.1f, 0.4f)});
    // Turned by a matrix without rounding, so that all of it lies at exactly 6.
    add_node(scene, "", 0, 0, Transform{glm::dmat3(1, 0, 0, 0, 0, 1, 0, 1, 0), Vec3d(0.4, 0, 6)});
    look_through_lens(scene);
    EXPECT_FALSE(stage_of(plan_for(scene), stage::blur).needed);
    EXPECT_EQ(stage_of(plan_for(scene), stage::blur).kind, Stage::exact);
    const OwnStudio studio(std::move(scene));
    for (const char* mode : modes) {
        const Outcome without = rendered(studio, mode),
                      with = rendered(studio, mode, forced("blur"));
        EXPECT_EQ(different_pixels(without, with), 0u) << mode;
        EXPECT_GT(std::ranges::count(without.frame.colour.pixels(), Rgb(0.9f, 0.1f, 0.4f)), 500);
    }
}

TEST(LayeredPlan, LeavesTheBlurOutWhereItIsBelowHalfAPixelAndSaysSo) {
    Scene near_focus = wall(6.005);
    const Stage blur = stage_of(plan_for(near_focus), stage::blur);
    // The wall has no end: its corners may be anywhere.
    EXPECT_TRUE(blur.needed);
    std::get<Plane>(near_focus.geometries[0]).limit = 20;
    const Stage small = stage_of(plan_for(near_focus), stage::blur);
    EXPECT_FALSE(small.needed);
    EXPECT_EQ(small.kind, Stage::bounded);
    EXPECT_FLOAT_EQ(small.bound, 0.5f);
    const OwnStudio studio(std::move(near_focus));
    const Outcome without = rendered(studio, "mode=lens");
    const Outcome with = rendered(studio, "mode=lens", forced("blur"));
    float most = 0, contrast = 0;
    for (std::size_t i = 0; i < with.frame.colour.pixels().size(); ++i) {
        const Rgb& pixel = with.frame.colour.pixels()[i];
        most = std::max(most, max_norm(pixel - without.frame.colour.pixels()[i]));
        contrast = std::max(contrast, max_norm(pixel));
    }
    EXPECT_LE(most, small.bound * contrast);
}

TEST(LayeredPlan, KeepsTheBlurWhereSomethingIsOutOfFocus) {
    Scene scene = wall(9);
    std::get<Plane>(scene.geometries[0]).limit = 20;
    EXPECT_TRUE(stage_of(plan_for(scene), stage::blur).needed);
    EXPECT_THAT(stage_of(plan_for(scene), stage::blur).why, HasSubstr("px"));
}

TEST(LayeredPlan, LooksBehindNothingWhereThereIsNothing) {
    Scene scene = testing::empty_scene();
    scene.settings.background = {0.2f, 0.4f, 0.1f};
    look_through_lens(scene);
    EXPECT_FALSE(stage_of(plan_for(scene), stage::behind).needed);
    EXPECT_FALSE(stage_of(plan_for(scene), stage::blur).needed);
    const OwnStudio studio(std::move(scene));
    for (const char* mode : modes) {
        Budget budget;
        budget.skip = false;
        EXPECT_EQ(different_pixels(rendered(studio, mode), rendered(studio, mode, budget)), 0u);
    }
}

TEST(LayeredPlan, TakesTheFrontFromTheItemBufferWithoutChangingABit) {
    for (Scene scene : {testing::one_triangle(), testing::one_of_each()}) {
        look_through_lens(scene);
        const bool meshes = scene.nodes.size() == 1;
        EXPECT_EQ(stage_of(plan_for(scene), stage::raster).needed, meshes);
        const OwnStudio studio(std::move(scene));
        for (const char* mode : modes) {
            Outcome traced = rendered(studio, mode);
            const Outcome rastered = rendered(studio, mode, forced("item buffer"));
            EXPECT_EQ(different_pixels(traced, rastered), 0u) << mode;
            EXPECT_TRUE(meshes || rastered.counts.fallbacks > 0);
            EXPECT_EQ(stage_of(rastered.plan, stage::raster).worked_on, "texels");
        }
    }
}

TEST(LayeredPlan, MergesLayersWhoseConfusionDiffersByLessThanHalfAPixel) {
    const Planes merged(8, -8, 200, true), all(8, -8, 200, false);
    EXPECT_EQ(all.count(), 200);
    EXPECT_LT(merged.count(), 70);
    for (double radius = -8; radius <= 8; radius += 0.01) {
        const double kept =
            merged.radius_px(static_cast<int>(std::lround(merged.position(radius))));
        EXPECT_LE(2 * std::abs(kept - radius), Planes::merged_px) << radius;
    }
    EXPECT_EQ(Planes(0.1, 0, 200, true).count(), 2);
    EXPECT_EQ(Planes(0, 0, 200, true).count(), 1);
}

TEST(LayeredPlan, SkipsSmallBlurWithinItsBound) {
    Scene scene = wall(6.02);
    testing::add_shape(scene, Cube{.centre = {0, 0, 60}, .side = 1}, {});
    const OwnStudio studio(std::move(scene));
    const Outcome skipped = rendered(studio, "mode=lens");
    const Outcome all = rendered(studio, "mode=lens", forced(stage::small));
    EXPECT_GT(different_pixels(skipped, all), 0u) << "the stage does something";
    float most = 0, contrast = 0;
    for (std::size_t i = 0; i < all.frame.colour.pixels().size(); ++i) {
        const Rgb& pixel = all.frame.colour.pixels()[i];
        most = std::max(most, max_norm(pixel - skipped.frame.colour.pixels()[i]));
        contrast = std::max(contrast, max_norm(pixel));
    }
    EXPECT_LE(most, Planes::merged_px * contrast);
}

TEST(LayeredPlan, IsNotForOtherProjections) {
    for (const Projection projection :
         {Projection::fisheye, Projection::spherical, Projection::orthographic}) {
        Scene scene = testing::one_of_each();
        look_through_lens(scene);
        scene.camera.projection = projection;
        const Plan plan = plan_for(scene);
        EXPECT_FALSE(plan.applies);
        EXPECT_THAT(plan.why, HasSubstr("not perspective"));
    }
}

}  // namespace
}  // namespace luch::techniques::layered
