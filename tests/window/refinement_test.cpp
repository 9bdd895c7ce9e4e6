#include "framework/window/refinement.h"

#include <gtest/gtest.h>

#include <vector>

namespace luch {
namespace {

/// Renders until nothing is left to do; the divisors, in order.
std::vector<int> divisors(Refinement& refinement, double whole_ms, bool moving = false) {
    std::vector<int> made;
    while (const auto divisor = refinement.next(moving, 0)) {
        refinement.started(*divisor);
        refinement.finished(0, whole_ms / (*divisor * *divisor));
        made.push_back(*divisor);
        if (made.size() > 10) break;
    }
    return made;
}

TEST(Refinement, BeginsCoarseAndEndsWhole) {
    Refinement refinement(true);
    EXPECT_FALSE(refinement.settled());
    EXPECT_EQ(divisors(refinement, 400), (std::vector{4, 2, 1}));
    EXPECT_TRUE(refinement.settled());
}

TEST(Refinement, AMovingPictureIsAsFineAsItsTimeAllows) {
    const auto next_after_move = [](double whole_ms) {
        Refinement refinement(true);
        divisors(refinement, whole_ms);
        refinement.changed();
        return divisors(refinement, whole_ms, true);
    };
    EXPECT_EQ(next_after_move(49), std::vector{1});
    EXPECT_EQ(next_after_move(51), std::vector{2});
    EXPECT_EQ(next_after_move(199), std::vector{2});
    EXPECT_EQ(next_after_move(201), std::vector{4});
    EXPECT_EQ(next_after_move(799), std::vector{4});
    EXPECT_EQ(next_after_move(60'000), std::vector{8});
}

TEST(Refinement, WithoutPreviewsEveryPictureIsWhole) {
    Refinement refinement(false);
    EXPECT_EQ(divisors(refinement, 60'000), std::vector{1});
    refinement.changed();
    EXPECT_EQ(divisors(refinement, 60'000), std::vector{1});
}

TEST(Refinement, AMoveCancelsAFinePicture) {
    Refinement refinement(true);
    divisors(refinement, 400);
    refinement.changed();
    refinement.started(1);
    EXPECT_EQ(refinement.next(true, 1), std::nullopt);
    refinement.changed();
    EXPECT_EQ(refinement.next(true, 1), 4);
}

TEST(Refinement, AMoveLetsACoarsePictureFinishForAWhile) {
    Refinement refinement(true);
    divisors(refinement, 400);
    refinement.changed();
    refinement.started(4);
    refinement.changed();
    EXPECT_EQ(refinement.next(true, 100), std::nullopt);
    EXPECT_EQ(refinement.next(true, 301), 4);
    refinement.finished(0, 25);
    EXPECT_EQ(refinement.next(true, 0), 4) << "the picture that came is out of date";
}

TEST(Refinement, AnotherTechniqueDoesNotWaitForAnything) {
    Refinement refinement(true);
    divisors(refinement, 4);
    refinement.changed();
    refinement.started(1);
    refinement.restart();
    EXPECT_EQ(refinement.next(false, 0), Refinement::first_guess);
}

TEST(Refinement, PreparationDoesNotGetCheaperWithSize) {
    Refinement refinement(true);
    refinement.started(4);
    refinement.finished(45, 1);  // 45 + 16/d² ≤ 50: half the width is enough
    refinement.changed();
    EXPECT_EQ(refinement.next(true, 0), 2);
}

TEST(Refinement, AFailureIsNotTriedAgainUntilSomethingChanges) {
    Refinement refinement(true);
    refinement.started(4);
    refinement.failed();
    EXPECT_EQ(refinement.next(false, 0), std::nullopt);
    refinement.changed();
    EXPECT_EQ(refinement.next(false, 0), Refinement::first_guess);
}

}  // namespace
}  // namespace luch
