#include "techniques/shadow_map/shadow_map.h"

#include "framework/technique/catalogue.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::homework::shadow_map {
TechniqueInfo describe();
namespace {

TEST(HomeworkShadowMap, IsInTheCatalogueUnderItsFolder) {
    EXPECT_EQ(describe().name, "homework/shadow_map");
}

TEST(HomeworkShadowMap, MakesTheReferencesPictureAndNamesItsHoles) {
    Scene scene = testing::one_of_each();
    scene.settings.frame = {64, 48};
    scene.camera.depth_of_field = true;
    scene.camera.f_number = 32;
    scene.camera.focal_distance = 5;
    const testing::OwnStudio studio(std::move(scene));
    const std::unique_ptr<Technique> yours = describe().create();
    const auto reference = techniques::shadow_map::make(techniques::shadow_map::reference());
    const Outcome got = studio.render(*yours), expected = studio.render(*reference);
    EXPECT_EQ(testing::different_pixels(got, expected), 0u);
    EXPECT_TRUE(expected.unwritten.empty());
    EXPECT_THAT(got.unwritten, ::testing::ElementsAre("shadow_map.t1", "shadow_map.t2",
                                                      "shadow_map.t4", "shadow_map.t5"));
    set_param(*yours, "mode=classic");
    EXPECT_THAT(studio.render(*yours).unwritten, ::testing::Contains("shadow_map.t3"));
}

}  // namespace
}  // namespace luch::homework::shadow_map
