#include "techniques/ssao/ssao.h"

#include "framework/technique/catalogue.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::homework::ssao {
TechniqueInfo describe();
namespace {

TEST(HomeworkSsao, IsInTheCatalogueUnderItsFolder) {
    EXPECT_EQ(describe().name, "homework/ssao");
}

TEST(HomeworkSsao, MakesTheReferencesPictureAndNamesItsHoles) {
    Scene scene = testing::one_of_each();
    scene.settings.frame = {64, 48};
    const testing::OwnStudio studio(std::move(scene));
    const std::unique_ptr<Technique> yours = describe().create();
    const auto reference = techniques::ssao::make(techniques::ssao::reference());
    const Outcome got = studio.render(*yours), expected = studio.render(*reference);
    EXPECT_EQ(testing::different_pixels(got, expected), 0u);
    EXPECT_TRUE(expected.unwritten.empty());
    EXPECT_THAT(got.unwritten, ::testing::ElementsAre("ssao.t1", "ssao.t2", "ssao.t3", "ssao.t4",
                                                      "ssao.t5", "ssao.t7"));
    set_param(*yours, "half=on");
    EXPECT_THAT(studio.render(*yours).unwritten, ::testing::Contains("ssao.t6"));
}

}  // namespace
}  // namespace luch::homework::ssao
