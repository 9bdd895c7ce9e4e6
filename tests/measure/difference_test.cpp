#include "framework/measure/difference.h"

#include "framework/base/error.h"
#include "framework/image/io.h"
#include "tests/measure/samples.h"

#include <gmock/gmock.h>

#include <cmath>

namespace luch {
namespace {

TEST(Difference, IsAmplifiedAndClamped) {
    const Image<Rgb> a({1, 1}, Rgb(0.5f)), b({1, 1}, Rgb(0.25f, 0.75f, 0.5f));
    EXPECT_EQ(amplified_difference(a.view(), b.view(), 2)(0, 0), Rgb(0.5f, 0.5f, 0));
    EXPECT_EQ(amplified_difference(a.view(), b.view(), 100)(0, 0), Rgb(1, 1, 0));
    EXPECT_THROW(amplified_difference(a.view(), Image<Rgb>({2, 1}).view(), 1), Error);
}

TEST(Difference, OfAPixelThatIsNotFiniteIsMagenta) {
    const Image<Rgb> a({1, 1}), b({1, 1}, Rgb(0, std::nanf(""), 0));
    EXPECT_EQ(amplified_difference(a.view(), b.view(), 1)(0, 0), Rgb(1, 0, 1));
    EXPECT_EQ(error_map(a.view(), b.view())(0, 0), Rgb(1, 0, 1));
}

TEST(ErrorColour, IsBlackForNoErrorAndBrighterForALargerOne) {
    EXPECT_EQ(error_colour(0), Rgb(0));
    double before = 0;
    for (const double error : {0.5 / 255, 1.0 / 255, 4.0 / 255, 16.0 / 255, 64.0 / 255, 1.0}) {
        const Rgb colour = error_colour(error);
        const double brightness = 0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b;
        EXPECT_GT(brightness, before) << error;
        before = brightness;
    }
}

TEST(ErrorColour, IsThatOfTheLegendAtItsTicks) {
    for (const LegendTick& tick : error_legend()) {
        const Rgb colour = error_colour(std::stod(tick.label) / 255);
        EXPECT_LT(glm::distance(colour, legend_colour(tick.position)), 1e-5f) << tick.label;
    }
}

TEST(WriteDisplayed, StoresTheNumbersThatItWasGiven) {
    const auto file = testing::empty_folder("displayed") / "grey.png";
    const Image<Rgb> grey({2, 2}, Rgb(100 / 255.0f));
    write_displayed(file, grey.view());
    EXPECT_EQ(read_picture(file).pixels(1, 1), Rgb(100 / 255.0f));
}

}  // namespace
}  // namespace luch
