#include "techniques/vista/vista.h"

#include "framework/technique/catalogue.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

namespace luch::homework::vista {
TechniqueInfo describe();
namespace {

TEST(HomeworkVista, IsInTheCatalogueUnderItsFolder) {
    EXPECT_EQ(describe().name, "homework/vista");
}

TEST(HomeworkVista, MakesTheReferencesPictureAndNamesItsHoles) {
    const testing::OwnStudio studio(testing::one_of_each());
    const Outcome yours = studio.render(*describe().create());
    const auto reference = techniques::vista::make(techniques::vista::reference());
    const Outcome expected = studio.render(*reference);
    EXPECT_EQ(testing::different_pixels(yours, expected), 0u);
    EXPECT_EQ(testing::plane_of<NodeId>(yours, "ids"), testing::plane_of<NodeId>(expected, "ids"));
    EXPECT_TRUE(expected.unwritten.empty());
    EXPECT_EQ(yours.unwritten,
              (std::vector<std::string>{"vista.t1", "vista.t2", "vista.t3", "vista.t4", "vista.t5",
                                        "vista.t6", "vista.t7"}));
}

}  // namespace
}  // namespace luch::homework::vista
