#include "framework/grading/check.h"
#include "tests/grading/fake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::grading {
namespace {

TEST(KillMatrix, KnowsEveryMutantByItsFailures) {
    const Homework homework = fake::homework(fake::right);
    const Matrix matrix = kill_matrix(homework, {});
    ASSERT_EQ(matrix.rows.size(), 2u);
    EXPECT_EQ(matrix.rows[0].likely, "doubled");
    EXPECT_EQ(matrix.rows[1].likely, "off_by_one");
    EXPECT_THAT(matrix.rows[1].failures, ::testing::ElementsAre(2u, 0u));
    EXPECT_TRUE(all_killed(matrix));
}

TEST(KillMatrix, IsNotContentWithAMutantThatLives) {
    Homework homework = fake::homework(fake::right);
    homework.mutants.push_back({"none", "fake.t1", "no mistake", fake::Steps{fake::right}});
    EXPECT_FALSE(all_killed(kill_matrix(homework, {})));
}

TEST(KillMatrix, IsNotContentWithOneScene) {
    Homework homework = fake::homework(fake::right);
    homework.mutants = {{"far", "fake.t1", "wrong for the large",
                         fake::Steps{[](int x) { return x > 5 ? 0 : x * x; }}}};
    EXPECT_FALSE(all_killed(kill_matrix(homework, {})));
}

TEST(KillMatrix, IsNotContentWithTwoMutantsThatCannotBeToldApart) {
    Homework homework = fake::homework(fake::right);
    homework.mutants.push_back(
        {"again", "fake.t1", "the same mistake", fake::Steps{fake::doubled}});
    EXPECT_FALSE(all_killed(kill_matrix(homework, {})));
}

TEST(VariantMatrix, IsNotContentWithAVariantThatFails) {
    Homework homework = fake::homework(fake::right);
    EXPECT_TRUE(all_passed(variant_matrix(homework, {})));
    homework.variants.push_back({"wrong", "fake.t1", "", fake::Steps{fake::off_by_one}});
    const Matrix matrix = variant_matrix(homework, {});
    EXPECT_FALSE(all_passed(matrix));
    EXPECT_THAT(matrix_text(matrix), ::testing::HasSubstr("fake.t1.squares on small"));
}

}  // namespace
}  // namespace luch::grading
