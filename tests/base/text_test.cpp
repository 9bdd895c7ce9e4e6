#include "framework/base/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch {
namespace {

using testing::ElementsAre;

constexpr std::string_view classes[] = {"Sphere", "Plane", "Phong", "Lambert"};

TEST(NearestNames, AreSortedByEditDistance) {
    EXPECT_THAT(nearest_names("Plan", classes), ElementsAre("Plane", "Phong", "Sphere"));
}

TEST(NearestNames, IgnoreCase) {
    constexpr std::string_view names[] = {"PLATE", "plane"};
    EXPECT_THAT(nearest_names("PLANE", names, 1), ElementsAre("plane"));
}

TEST(NearestNames, AreNoMoreThanThereAre) {
    EXPECT_EQ(nearest_names("x", classes, 10).size(), 4u);
}

TEST(DidYouMean, ListsTheNearestNames) {
    EXPECT_EQ(did_you_mean("Plan", classes), "did you mean Plane, Phong or Sphere?");
}

TEST(DidYouMean, SaysWhenThereIsNothingToMean) {
    EXPECT_EQ(did_you_mean("x", {}), "there are none to choose from");
}

TEST(Listed, JoinsOneTwoAndThreeWords) {
    const std::vector<std::string> words{"a", "b", "c"};
    EXPECT_EQ(listed(std::span(words).first(0)), "");
    EXPECT_EQ(listed(std::span(words).first(1)), "a");
    EXPECT_EQ(listed(std::span(words).first(2)), "a or b");
    EXPECT_EQ(listed(words, "and"), "a, b and c");
}

TEST(Trimmed, LosesBlanksAtBothEndsOnly) {
    EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
    EXPECT_EQ(trimmed(" \t "), "");
}

TEST(Split, KeepsEmptyPieces) {
    EXPECT_THAT(split("a,,b", ','), ElementsAre("a", "", "b"));
    EXPECT_THAT(split("", ','), ElementsAre(""));
}

TEST(ParsedNumber, TakesWhatSceneFilesHold) {
    EXPECT_EQ(parsed_number("278."), 278);
    EXPECT_EQ(parsed_number(".5"), 0.5);
    EXPECT_EQ(parsed_number("+1e3"), 1000);
    EXPECT_EQ(parsed_number("-0.125"), -0.125);
}

TEST(ParsedNumber, TakesNothingElse) {
    for (const char* text : {"", "+", "-", "+-1", "1 ", " 1", "1x", "0x10", "nan", "inf", "-inf",
                             "1e999", "1,5", "--1"}) {
        EXPECT_EQ(parsed_number(text), std::nullopt) << text;
    }
}

}  // namespace
}  // namespace luch
