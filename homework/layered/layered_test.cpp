#include "techniques/layered/layered.h"

#include "framework/technique/catalogue.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::homework::layered {
TechniqueInfo describe();
namespace {

TEST(HomeworkLayered, IsInTheCatalogueUnderItsFolder) {
    EXPECT_EQ(describe().name, "homework/layered");
}

TEST(HomeworkLayered, MakesTheReferencesPictureAndNamesItsHoles) {
    Scene scene = testing::one_of_each();
    scene.settings.frame = {64, 48};
    scene.camera.depth_of_field = true;
    scene.camera.f_number = 32;
    scene.camera.focal_distance = 5;
    const testing::OwnStudio studio(std::move(scene));
    const std::unique_ptr<Technique> yours = describe().create();
    const auto reference = techniques::layered::make(techniques::layered::reference());
    const Outcome got = studio.render(*yours), expected = studio.render(*reference);
    EXPECT_EQ(testing::different_pixels(got, expected), 0u);
    EXPECT_TRUE(expected.unwritten.empty());
    EXPECT_THAT(got.unwritten,
                ::testing::ElementsAre("layered.t1", "layered.t2", "layered.t4", "layered.t5"));
    set_param(*yours, "mode=classic");
    EXPECT_THAT(studio.render(*yours).unwritten, ::testing::Contains("layered.t3"));
}

}  // namespace
}  // namespace luch::homework::layered
