#include "framework/window/compose.h"

#include "framework/window/text.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

constexpr Pixel green{0, 200, 0}, blue{0, 0, 200}, black{};

TEST(Compose, TheWiperCutsAtItsExactColumn) {
    const Image<Pixel> left({100, 50}, green), right({100, 50}, blue);
    Composition composition{.window = {100, 50}, .frame = {100, 50}, .left = &left};
    composition.right = &right;
    composition.split = 0.37;
    const Image<Pixel> picture = composed(composition);
    for (int x = 0; x < 100; ++x) {
        // Below the labels.
        const Pixel expected = x < 37 ? green : x > 37 ? blue : Pixel{255, 255, 255};
        ASSERT_EQ(picture(x, 40), expected) << x;
    }
}

TEST(Compose, TheWiperReachesBothEdges) {
    const Image<Pixel> left({100, 50}, green), right({100, 50}, blue);
    Composition composition{.window = {100, 50}, .frame = {100, 50}, .left = &left};
    composition.right = &right;
    composition.split = 1;
    EXPECT_EQ(composed(composition)(99, 40), green);
    composition.split = -3;
    EXPECT_EQ(composed(composition)(1, 40), blue);
}

TEST(Compose, AFrameOfTheWindowsSizeIsShownPixelByPixel) {
    Image<Pixel> frame({31, 17});
    for (int y = 0; y < 17; ++y) {
        for (int x = 0; x < 31; ++x) {
            frame(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 9};
        }
    }
    const Image<Pixel> picture = composed({.window = {31, 17}, .frame = {31, 17}, .left = &frame});
    EXPECT_EQ(picture, frame);
}

TEST(Compose, ACoarsePictureIsStretchedOverTheFrame) {
    Image<Pixel> coarse({2, 1}, green);
    coarse(1, 0) = blue;
    const Image<Pixel> picture = composed({.window = {8, 4}, .frame = {8, 4}, .left = &coarse});
    for (int x = 0; x < 8; ++x) EXPECT_EQ(picture(x, 3), x < 4 ? green : blue);
}

TEST(Compose, TheFrameKeepsItsProportionsInTheMiddleOfTheWindow) {
    EXPECT_EQ(frame_area({400, 100}, {200, 100}), (Tile{100, 0, 300, 100}));
    EXPECT_EQ(frame_area({100, 400}, {640, 480}), (Tile{0, 162, 100, 237}));
    EXPECT_EQ(frame_area({1, 1}, {640, 480}), (Tile{0, 0, 1, 1}));
    EXPECT_EQ(frame_area({0, 0}, {640, 480}).area(), 0u);
    const Image<Pixel> frame({200, 100}, green);
    const Image<Pixel> picture =
        composed({.window = {400, 100}, .frame = {200, 100}, .left = &frame});
    EXPECT_EQ(picture(99, 50), black);
    EXPECT_EQ(picture(100, 50), green);
    EXPECT_EQ(picture(299, 50), green);
    EXPECT_EQ(picture(300, 50), black);
}

TEST(Compose, StatusTroubleAndHelpAreWrittenOverThePicture) {
    const Image<Pixel> frame({320, 200}, green);
    const Composition bare{.window = {320, 200}, .frame = {320, 200}, .left = &frame};
    const auto differing_rows = [&](const Composition& composition) {
        const Image<Pixel> picture = composed(composition);
        std::vector<int> rows;
        for (int y = 0; y < 200; ++y) {
            for (int x = 0; x < 320; ++x) {
                if (picture(x, y) == green) continue;
                rows.push_back(y);
                break;
            }
        }
        return rows;
    };
    EXPECT_TRUE(differing_rows(bare).empty());
    Composition status = bare, trouble = bare, help = bare;
    status.status = {"baseline  12.3 ms"};
    trouble.trouble = "ssao failed";
    help.help = {"Esc quit"};
    ASSERT_FALSE(differing_rows(status).empty());
    EXPECT_GT(differing_rows(status).front(), 170);
    ASSERT_FALSE(differing_rows(trouble).empty());
    EXPECT_GT(differing_rows(trouble).front(), 170);
    ASSERT_FALSE(differing_rows(help).empty());
    EXPECT_GT(differing_rows(help).front(), 80);
    EXPECT_LT(differing_rows(help).back(), 120);
}

TEST(Compose, NoWindowIsTooSmall) {
    const Image<Pixel> frame({64, 48}, green);
    for (const Size size : {Size{0, 0}, Size{1, 1}, Size{3, 2}, Size{1, 400}, Size{400, 1}}) {
        Composition composition{.window = size, .frame = {64, 48}, .left = &frame};
        composition.right = &frame;
        composition.left_label = composition.right_label = "a long name";
        composition.status = {"a status of several words"};
        composition.trouble = "trouble";
        composition.help = {"help", "more help"};
        EXPECT_EQ(composed(composition).size(), size);
    }
}

TEST(Text, CutsLinesAtBlanksAndLosesNoWord) {
    const std::string text =
        "vista does not apply: the scene has no light at all; baseline is shown";
    const std::vector<std::string> lines = wrapped(text, 1, 120);
    ASSERT_GT(lines.size(), 1u);
    std::string joined;
    for (const std::string& line : lines) {
        EXPECT_LE(text_width(line, 1), 120) << line;
        joined += (joined.empty() ? "" : " ") + line;
    }
    EXPECT_EQ(joined, text);
    EXPECT_EQ(wrapped("Donaudampfschiff", 1, 1).size(), 16u);
}

TEST(Text, DrawsWhatIsNotAsciiAsQuestionMarks) {
    Image<Pixel> cyrillic({100, 20}), marks({100, 20});
    draw_text(cyrillic.view(), 2, 2, 1, "л", green);
    draw_text(marks.view(), 2, 2, 1, "??", green);
    EXPECT_EQ(cyrillic, marks);
    EXPECT_NE(marks, (Image<Pixel>({100, 20})));
}

TEST(Text, FillMixesWithWhatIsBelow) {
    Image<Pixel> picture({2, 1}, Pixel{100, 0, 200});
    fill(picture.view(), {1, -5, 9, 9}, {200, 100, 0}, 0.5f);
    EXPECT_EQ(picture(0, 0), (Pixel{100, 0, 200}));
    EXPECT_EQ(picture(1, 0), (Pixel{150, 50, 100}));
}

}  // namespace
}  // namespace luch
