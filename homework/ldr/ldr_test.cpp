#include "techniques/ldr/ldr.h"

#include "framework/technique/catalogue.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

namespace luch::homework::ldr {
TechniqueInfo describe();
namespace {

TEST(HomeworkLdr, IsInTheCatalogueUnderItsFolder) {
    EXPECT_EQ(describe().name, "homework/ldr");
}

/// All steps are met by pictures with words alone, and with sums.
TEST(HomeworkLdr, MakesTheReferencesPictureAndNamesItsHoles) {
    Scene scene = testing::one_of_each();
    scene.settings.background = Rgb(0.2f, 0.4f, 0.8f);
    const testing::OwnStudio studio(std::move(scene));
    const auto expect_holes = [&](const char* param, int spp, std::vector<std::string> holes) {
        const auto yours = describe().create();
        const auto reference = techniques::ldr::make(techniques::ldr::reference());
        set_param(*yours, param);
        set_param(*reference, param);
        Shot shot = shot_of(studio.scene());
        shot.spp = spp;
        const Outcome made = studio.render(*yours, shot);
        const Outcome expected = studio.render(*reference, shot);
        EXPECT_EQ(testing::different_pixels(made, expected), 0u);
        EXPECT_TRUE(expected.unwritten.empty());
        EXPECT_EQ(made.unwritten, holes);
    };
    expect_holes("wide=off", 2, {"ldr.t1", "ldr.t2", "ldr.t3", "ldr.t4", "ldr.t5"});
    expect_holes("wide=on", 1, {"ldr.t7"});
}

}  // namespace
}  // namespace luch::homework::ldr
