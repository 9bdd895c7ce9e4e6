// The steps against closed forms.
#include "techniques/layered/layered.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <numbers>

namespace luch::techniques::layered {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
const Steps steps = reference();

/// f/5, in focus at 10, 100 pixels a unit at distance 1: 10 px at z = ∞.
const Lens lens{0.5, 10, 100, 500};

float coc_of(float z, const Lens& of = lens) {
    Image<float> depth({1, 1}, z), px({1, 1});
    steps.coc(depth.view(), of, {0, 0, 1, 1}, px.view());
    return px(0, 0);
}

Image<Rgba> blurred(const Image<Rgba>& in, float sigma, Axis axis = Axis::x) {
    Image<Rgba> out(in.size());
    steps.gaussian(in.view(), sigma, axis, in.view().tile(), out.view());
    return out;
}

Image<Rgba> spread(const Image<Rgba>& in, const Image<float>& coc) {
    Image<Rgba> out(in.size());
    steps.disc(in.view(), coc.view(), in.view().tile(), out.view());
    return out;
}

Image<Rgba> spread(const Image<Rgba>& in, float coc) {
    return spread(in, Image<float>(in.size(), coc));
}

/// Numbers without a pattern, some of them large.
Image<Rgba> noise(Size size) {
    Image<Rgba> image(size);
    unsigned state = 1;
    for (Rgba& pixel : image.pixels()) {
        for (int k = 0; k < 4; ++k) {
            state = state * 1664525u + 1013904223u;
            pixel[k] = static_cast<float>(state >> 8) * 0x1p-24f;
        }
        if (state % 7 == 0) pixel.r *= 1e6f;
    }
    return image;
}

double mean_red(const Image<Rgba>& image) {
    double sum = 0;
    for (const Rgba& pixel : image.pixels()) sum += pixel.r;
    return sum / static_cast<double>(image.pixels().size());
}

/// The share of a disc on the far side of a line at t radii from its centre.
double segment(double t) {
    if (std::abs(t) >= 1) return t < 0 ? 1 : 0;
    return (std::acos(t) - t * std::sqrt(1 - t * t)) / std::numbers::pi;
}

/// White from the column `edge` on.
Image<Rgba> half_plane(Size size, int edge) {
    Image<Rgba> image(size, Rgba(0));
    for (int y = 0; y < size.height; ++y) {
        for (int x = edge; x < size.width; ++x) image(x, y) = Rgba(1);
    }
    return image;
}

TEST(Cut, MakesLayersOfEqualThicknessInInverseDepth) {
    const std::array depths{4.0f, 1.0f, 2.0f};
    std::array<float, 3> cuts{};
    steps.cut(depths, 4, cuts);
    // 1/z runs from 1 to 1/4.
    EXPECT_FLOAT_EQ(cuts[0], 1 / 0.8125f);
    EXPECT_FLOAT_EQ(cuts[1], 1 / 0.625f);
    EXPECT_FLOAT_EQ(cuts[2], 1 / 0.4375f);
}

TEST(Cut, CountsTheSkyAndNoDepthThatIsNone) {
    const std::array depths{2.0f, infinite, -3.0f, 0.0f, std::nanf("")};
    std::array<float, 1> cuts{};
    steps.cut(depths, 2, cuts);
    EXPECT_FLOAT_EQ(cuts[0], 4);
    steps.cut(std::span(depths).subspan(2), 2, cuts);
    EXPECT_EQ(cuts[0], infinite);
    steps.cut(std::span(depths).subspan(1, 1), 2, cuts);
    EXPECT_EQ(cuts[0], infinite);
}

TEST(Coc, IsTheThinLenssFormula) {
    for (const float z : {0.3f, 4.0f, 9.0f, 10.5f, 30.0f, 4000.0f}) {
        const double expected = 2 * 0.5 * std::abs(z - 10.0) / (z * 10.0) * 100;
        EXPECT_NEAR(coc_of(z), expected, 1e-5 * expected) << z;
    }
    EXPECT_EQ(coc_of(10), 0);
}

TEST(Coc, IsThatOfTheScenesCamera) {
    Camera camera;
    camera.depth_of_field = true;
    camera.f_number = 1.25;
    camera.focal_distance = 61;
    camera.fov_deg = 60;
    const double m = std::tan(30 * std::numbers::pi / 180) / std::sqrt(16.0 / 9 + 1);
    const double expected = 5 / 1.25 * (180.0 - 61) / (180.0 * 61) * 240 / (2 * m);
    EXPECT_NEAR(coc_of(180, lens_of(camera, {320, 240})), expected, 1e-4);
    camera.depth_of_field = false;
    EXPECT_EQ(coc_of(180, lens_of(camera, {320, 240})), 0);
}

TEST(Coc, HasALimitAtBothEnds) {
    EXPECT_FLOAT_EQ(coc_of(infinite), 10);
    EXPECT_FLOAT_EQ(coc_of(std::numeric_limits<float>::max()), 10);
    for (const float z : {0.0f, -1.0f, 1e-30f, std::nanf("")}) EXPECT_EQ(coc_of(z), 500) << z;
}

TEST(Gaussian, IsTheIdentityBitForBitWhenSigmaGoesToZero) {
    const Image<Rgba> in = noise({19, 7});
    for (const float sigma : {0.0f, -1.0f, 1e-30f, 1e-6f}) {
        EXPECT_EQ(blurred(in, sigma), in) << sigma;
        EXPECT_EQ(blurred(in, sigma, Axis::y), in) << sigma;
    }
}

TEST(Gaussian, IsFiniteAndKeepsTheMeanWhenItIsMuchLargerThanThePicture) {
    const Image<Rgba> in = noise({19, 1});
    for (const float sigma : {1e6f, 1e30f, infinite}) {
        const Image<Rgba> out = blurred(in, sigma);
        for (const Rgba& pixel : out.pixels()) {
            EXPECT_NEAR(pixel.r, mean_red(in), 1e-6 * mean_red(in)) << sigma;
        }
    }
}

TEST(Gaussian, KeepsAConstantPictureAtItsBorders) {
    for (const float sigma : {0.4f, 1.0f, 3.7f, 40.0f}) {
        const Image<Rgba> out = blurred(Image<Rgba>({23, 5}, Rgba(0.7f)), sigma);
        for (const Rgba& pixel : out.pixels()) {
            EXPECT_NEAR(pixel.g, 0.7f, 1e-6) << sigma;
        }
    }
}

TEST(Gaussian, EndsAtThreeSigmaAndMakesUpForIt) {
    Image<Rgba> in({41, 1}, Rgba(0));
    in(20, 0) = Rgba(1);
    const Image<Rgba> out = blurred(in, 3);
    EXPECT_GT(out(11, 0).r, 0);
    EXPECT_EQ(out(10, 0).r, 0);
    EXPECT_NEAR(mean_red(out) * 41, 1, 1e-6);
    EXPECT_NEAR(out(23, 0).r / out(20, 0).r, std::exp(-0.5), 1e-6);
}

TEST(Gaussian, DoesNotSpreadWhatIsNotFinite) {
    Image<Rgba> in({9, 1}, Rgba(0.5f));
    in(4, 0).g = infinite;
    in(5, 0).a = std::nanf("");
    const Image<Rgba> out = blurred(in, 2);
    EXPECT_EQ(out(4, 0).g, infinite);
    EXPECT_TRUE(std::isnan(out(5, 0).a));
    EXPECT_NEAR(out(3, 0).g, 0.5, 1e-6);
}

TEST(Gaussian, BlursAlongItsOwnAxisOnly) {
    Image<Rgba> in({9, 9}, Rgba(0));
    in(4, 4) = Rgba(1);
    EXPECT_EQ(blurred(in, 1, Axis::x)(4, 3).r, 0);
    EXPECT_GT(blurred(in, 1, Axis::x)(3, 4).r, 0.1f);
    EXPECT_GT(blurred(in, 1, Axis::y)(4, 3).r, 0.1f);
}

TEST(Disc, TurnsAHalfPlaneIntoCircularSegments) {
    constexpr int edge = 50;
    for (const float diameter : {12.0f, 24.5f, 41.0f}) {
        const Image<Rgba> out = spread(half_plane({100, 80}, edge), diameter);
        for (int x = 28; x < 72; ++x) {
            const double t = (edge - (x + 0.5)) / (diameter / 2);
            EXPECT_NEAR(out(x, 40).a, segment(t), 0.3 / diameter) << diameter << " " << x;
        }
    }
}

TEST(Disc, TurnsAPointIntoADiscOfEqualEnergy) {
    Image<Rgba> in({61, 61}, Rgba(0));
    in(30, 30) = Rgba(7, 3, 1, 1);
    const Image<Rgba> out = spread(in, 21);
    double energy = 0, covered = 0;
    for (int y = 0; y < 61; ++y) {
        for (int x = 0; x < 61; ++x) {
            energy += out(x, y).r;
            covered += out(x, y).r > 0;
            const double off = std::hypot(x - 30, y - 30);
            EXPECT_EQ(out(x, y).r > 0, off <= 10.5) << x << " " << y;
        }
    }
    EXPECT_NEAR(energy, 7, 1e-5);
    EXPECT_NEAR(covered, std::numbers::pi * 10.5 * 10.5, 0.03 * covered);
    EXPECT_FLOAT_EQ(out(30, 30).r, out(38, 36).r) << "even, not brighter in the middle";
}

TEST(Disc, KeepsAConstantPictureAtItsBordersAndWhereConfusionChanges) {
    Image<float> coc({40, 30});
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) coc(x, y) = 0.4f * static_cast<float>(x);
    }
    const Image<Rgba> out = spread(Image<Rgba>({40, 30}, Rgba(0.3f)), coc);
    for (const Rgba& pixel : out.pixels()) EXPECT_NEAR(pixel.a, 0.3f, 1e-6);
}

TEST(Disc, CopiesWhatIsInFocus) {
    const Image<Rgba> in = noise({31, 17});
    EXPECT_EQ(spread(in, 0), in);
    EXPECT_EQ(spread(in, 1), in);
    Image<float> coc(in.size(), 0);
    coc(30, 16) = 9;
    EXPECT_EQ(spread(in, coc)(0, 0), in(0, 0));
}

TEST(Disc, IsFiniteWithAHighlightAndALargeKernel) {
    Image<Rgba> in({20, 10}, Rgba(0.1f));
    in(3, 3) = Rgba(1e30f, 0, 0, 1);
    in(9, 9).r = infinite;
    for (const float diameter : {3.0f, 30.0f, 1e6f}) {
        const Image<Rgba> out = spread(in, diameter);
        for (int x = 0; x < 20; ++x) EXPECT_TRUE(std::isfinite(out(x, 5).r)) << diameter;
        EXPECT_LE(out(3, 3).r, 1e30f);
        EXPECT_EQ(out(9, 9).r, infinite);
    }
}

TEST(Over, ShowsTheBackThroughWhatIsPremultiplied) {
    Image<Rgba> front({1, 1}, Rgba(0.25f, 0, 0, 0.25f)), back({1, 1}, Rgba(0, 0, 0.8f, 1));
    steps.over(front.view(), {0, 0, 1, 1}, back.view());
    EXPECT_EQ(back(0, 0), Rgba(0.25f, 0, 0.6f, 1)) << "straight alpha would give 0.0625";
}

TEST(Over, IsAssociativeAndPutsTheFirstOnTop) {
    const Image<Rgba> a = noise({8, 8}), c({8, 8}, Rgba(0.2f, 0.4f, 0.1f, 0.5f));
    Image<Rgba> b({8, 8}, Rgba(0.1f, 0.5f, 0.3f, 0.6f)), ab = b, bc = c, left = c, right;
    const Tile whole{0, 0, 8, 8};
    steps.over(a.view(), whole, ab.view());
    steps.over(ab.view(), whole, left.view());
    steps.over(b.view(), whole, bc.view());
    right = bc;
    steps.over(a.view(), whole, right.view());
    for (std::size_t i = 0; i < left.pixels().size(); ++i) {
        EXPECT_NEAR(left.pixels()[i].g, right.pixels()[i].g, 1e-6);
        EXPECT_NEAR(left.pixels()[i].a, right.pixels()[i].a, 1e-6);
    }
}

TEST(Over, LetsNothingThroughWhatCoversAll) {
    Image<Rgba> front({1, 1}, Rgba(0.5f, 0.5f, 0.5f, 1)), back({1, 1}, Rgba(infinite));
    steps.over(front.view(), {0, 0, 1, 1}, back.view());
    EXPECT_EQ(back(0, 0), front(0, 0));
}

/// How far a gaussian-blurred edge is at most from that of a disc, in the limit of many pixels.
double largest_difference(float sigma_of_disc) {
    constexpr int edge = 400;
    constexpr float diameter = 200;
    const Image<Rgba> out = blurred(half_plane({800, 1}, edge), sigma_of_disc * diameter);
    double largest = 0;
    for (int x = 0; x < 800; ++x) {
        const double t = (edge - (x + 0.5)) / (diameter / 2);
        largest = std::max(largest, std::abs(out(x, 0).a - segment(t)));
    }
    return largest;
}

TEST(Gaussian, StaysAwayFromTheDiscHoweverItIsTuned) {
    EXPECT_NEAR(largest_difference(0.25f), 0.041, 0.002);
    EXPECT_NEAR(largest_difference(0.27f), 0.033, 0.002);
    for (float sigma = 0.15f; sigma < 0.4f; sigma += 0.01f) {
        EXPECT_GT(largest_difference(sigma), 0.028) << sigma;
    }
}

/// Runs a step on the whole, in tiles and pixel by pixel.
template <class Run>
void expect_same_in_tiles(Size size, Run&& run) {
    Image<Rgba> whole(size);
    run(Tile{0, 0, size.width, size.height}, whole);
    for (const int side : {1, 5, 16}) {
        Image<Rgba> tiled(size);
        for (int y = 0; y < size.height; y += side) {
            for (int x = 0; x < size.width; x += side) {
                run({x, y, std::min(x + side, size.width), std::min(y + side, size.height)}, tiled);
            }
        }
        EXPECT_EQ(tiled, whole) << side;
    }
}

TEST(LayeredSteps, GiveTheSameBitsForAnyTiles) {
    const Size size{37, 21};
    const Image<Rgba> in = noise(size);
    Image<float> coc(size);
    for (std::size_t i = 0; i < coc.pixels().size(); ++i) coc.pixels()[i] = in.pixels()[i].a * 12;
    expect_same_in_tiles(size, [&](Tile tile, Image<Rgba>& out) {
        steps.gaussian(in.view(), 2.3f, Axis::y, tile, out.view());
    });
    expect_same_in_tiles(size, [&](Tile tile, Image<Rgba>& out) {
        steps.disc(in.view(), coc.view(), tile, out.view());
    });
    expect_same_in_tiles(
        size, [&](Tile tile, Image<Rgba>& out) { steps.over(in.view(), tile, out.view()); });
}

}  // namespace
}  // namespace luch::techniques::layered
