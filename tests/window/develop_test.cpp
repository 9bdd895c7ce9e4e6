#include "framework/window/develop.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace luch {
namespace {

constexpr Pixel magenta{255, 0, 255}, black{}, white{255, 255, 255};
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

int lightness(const Pixel& pixel) {
    return 2 * pixel.r + 7 * pixel.g + pixel.b;
}

template <class T>
Plane2d plane_of(PlaneKind kind, std::vector<T> values) {
    Plane2d plane{"plane", kind, "", 2, 10, Image<T>({static_cast<int>(values.size()), 1})};
    std::get<Image<T>>(plane.pixels).pixels() = std::move(values);
    return plane;
}

TEST(Develop, ColourIsEncodedAndWhatIsNotFiniteIsMagenta) {
    Frame frame({4, 1});
    frame.colour.pixels() = {Rgb(0.5f, 0, 1), Rgb(2, -1, 0.18f), Rgb(nan, 0, 0),
                             Rgb(0, infinity, 0)};
    const Image<Pixel> picture = developed(frame, Workers(2));
    EXPECT_EQ(picture(0, 0), (Pixel{188, 0, 255}));
    EXPECT_EQ(picture(1, 0), (Pixel{255, 0, 118}));
    EXPECT_EQ(picture(2, 0), magenta);
    EXPECT_EQ(picture(3, 0), magenta);
}

TEST(Develop, ScalarsGetLighterFromLeastToMostAndAreClamped) {
    const Image<Pixel> picture =
        developed(plane_of<float>(PlaneKind::scalar, {-5, 2, 4, 6, 8, 10, 99, nan, infinity}));
    EXPECT_EQ(picture(0, 0), picture(1, 0));
    for (int x = 1; x < 5; ++x) EXPECT_LT(lightness(picture(x, 0)), lightness(picture(x + 1, 0)));
    EXPECT_EQ(picture(5, 0), picture(6, 0));
    EXPECT_EQ(picture(7, 0), magenta);
    EXPECT_EQ(picture(8, 0), magenta);
}

TEST(Develop, AScalarWithoutARangeIsOneColour) {
    Plane2d plane = plane_of<float>(PlaneKind::scalar, {1, 2, 3});
    plane.least = plane.most = 2;
    const Image<Pixel> picture = developed(plane);
    const Pixel least = developed(plane_of<float>(PlaneKind::scalar, {2}))(0, 0);
    EXPECT_EQ(picture, (Image<Pixel>({3, 1}, least)));
}

TEST(Develop, NeighbouringIdsDifferAndNoneIsBlack) {
    std::vector<std::uint32_t> ids{~0u};
    for (std::uint32_t id = 0; id < 200; ++id) ids.push_back(id);
    const Image<Pixel> picture = developed(plane_of<std::uint32_t>(PlaneKind::id, ids));
    EXPECT_EQ(picture(0, 0), black);
    std::set<std::tuple<int, int, int>> colours;
    for (int x = 1; x < picture.width(); ++x) {
        const Pixel& pixel = picture(x, 0);
        colours.insert({pixel.r, pixel.g, pixel.b});
        const Pixel& before = picture(x - 1, 0);
        EXPECT_GT(std::abs(pixel.r - before.r) + std::abs(pixel.g - before.g) +
                      std::abs(pixel.b - before.b),
                  8)
            << x;
    }
    EXPECT_EQ(colours.size(), 200u);
}

TEST(Develop, NormalsMasksAndColours) {
    const Image<Pixel> normals =
        developed(plane_of<Rgb>(PlaneKind::normal, {Rgb(1, 0, -1), Rgb(nan, 0, 0)}));
    EXPECT_EQ(normals(0, 0), (Pixel{255, 128, 0}));
    EXPECT_EQ(normals(1, 0), magenta);
    const Image<Pixel> mask = developed(plane_of<std::uint8_t>(PlaneKind::mask, {0, 1, 255}));
    EXPECT_EQ(mask(0, 0), black);
    EXPECT_EQ(mask(1, 0), white);
    EXPECT_EQ(mask(2, 0), white);
    const Image<Pixel> colours = developed(plane_of<Rgb>(PlaneKind::colour, {Rgb(0.5f)}));
    EXPECT_EQ(colours(0, 0), (Pixel{188, 188, 188}));
}

TEST(Develop, MarksAreOutlinesAndStayInside) {
    Image<Pixel> picture({12, 9});
    const Rgb colour(1);
    draw_marks(picture.view(), {{Mark::rectangle, 2, 1, 8, 6, colour}});
    int drawn = 0;
    for (const Pixel& pixel : picture.pixels()) drawn += pixel == white ? 1 : 0;
    EXPECT_EQ(drawn, 2 * 6 + 2 * 3);  // 6 wide, 5 high
    EXPECT_EQ(picture(2, 1), white);
    EXPECT_EQ(picture(7, 5), white);
    EXPECT_EQ(picture(4, 3), black);

    draw_marks(picture.view(), {{Mark::line, -1e9f, -1e9f, 1e9f, 1e9f, colour},
                                {Mark::line, nan, 0, 5, infinity, colour},
                                {Mark::line, 11, 0, 11, 8, colour}});
    EXPECT_EQ(picture(11, 8), white);
}

}  // namespace
}  // namespace luch
