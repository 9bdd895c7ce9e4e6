#include "techniques/shadow_map/shadow_map.h"

#include "framework/technique/catalogue.h"
#include "framework/technique/todo.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

namespace luch::homework::shadow_map {
TechniqueInfo describe();
namespace {

TEST(HomeworkShadowMap, IsInTheCatalogueUnderItsFolder) {
    EXPECT_EQ(describe().name, "homework/shadow_map");
}

Scene scene_with_an_area_light() {
    Scene scene = testing::one_of_each();
    scene.settings.frame = {64, 48};
    const Transform above = Transform::translation({0, 6, 0});
    add_rect_light(scene, "window", {.to_world = above, .power = 20});
    return scene;
}

TEST(HomeworkShadowMap, MakesTheReferencesPictureAndNamesItsHoles) {
    const testing::OwnStudio studio(scene_with_an_area_light());
    const auto yours = describe().create();
    const auto reference = techniques::shadow_map::make(techniques::shadow_map::reference());
    for (const auto& technique : {yours.get(), reference.get()}) set_param(*technique, "side=64");
    const Outcome got = studio.render(*yours), expected = studio.render(*reference);
    EXPECT_EQ(testing::different_pixels(got, expected), 0u);
    EXPECT_TRUE(expected.unwritten.empty());
    // t1 and t2 are called by the steps themselves.
    EXPECT_THAT(got.unwritten, ::testing::ElementsAre("shadow_map.t3", "shadow_map.t4",
                                                      "shadow_map.t6", "shadow_map.t7"));
    set_param(*yours, "pcf=off");
    EXPECT_THAT(studio.render(*yours).unwritten, ::testing::Contains("shadow_map.t5"));
}

std::atomic<int> holes_met = 0;

/// Thousands of points are seen alone, in mirrors; each hole would cost more than the point.
TEST(HomeworkShadowMap, MeetsAHoleOnceAFrame) {
    using namespace techniques::shadow_map;
    Steps steps = reference();
    steps.pcf = [](const CubeMap&, std::span<const Receiver>, std::span<const float>,
                   std::span<float>) {
        ++holes_met;
        LUCH_TODO("shadow_map.t6");
    };
    const testing::OwnStudio studio(scene_with_an_area_light());
    const auto technique = make(steps), whole = make(reference());
    for (const auto& each : {technique.get(), whole.get()}) set_param(*each, "side=64");
    const Outcome got = studio.render(*technique);
    EXPECT_EQ(holes_met, 1);
    EXPECT_THAT(got.unwritten, ::testing::ElementsAre("shadow_map.t6"));
    EXPECT_EQ(testing::different_pixels(got, studio.render(*whole)), 0u);
}

}  // namespace
}  // namespace luch::homework::shadow_map
