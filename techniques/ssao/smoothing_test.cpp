// Blur, upsampling and light against closed forms.
#include "techniques/ssao/seen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace luch::techniques::ssao {
namespace {

const Steps steps = reference();

/// A plane at depth 10 in the middle of the frame, turned from facing the eye.
FlatThing tilted(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3d normal(0, std::sin(angle), -std::cos(angle));
    return {normal, glm::dot(normal, Vec3d(0, 0, 10))};
}
double mean(const Image<float>& image) {
    double sum = 0;
    for (const float value : image.pixels()) sum += value;
    return sum / static_cast<double>(image.pixels().size());
}

Image<float> blurred(const Image<float>& in, const Seen& seen, const Blur& blur) {
    Image<float> between(in.size()), out(in.size());
    steps.blur(in.view(), seen.buffer(), blur, Axis::x, in.view().tile(), between.view());
    steps.blur(between.view(), seen.buffer(), blur, Axis::y, in.view().tile(), out.view());
    return out;
}

/// 1 on what is seen of the first of two things.
Image<float> ones_on(const Seen& seen, float nearer_than) {
    Image<float> image(seen.depth.size());
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        image.pixels()[i] = seen.depth.pixels()[i] < nearer_than ? 1 : 0;
    }
    return image;
}

const std::vector<FlatThing> step_in_depth{{{0, 0, -1}, -20}, {{0, 0, -1}, -10, 0}};

TEST(BlurStep, KeepsAConstantAndTheMean) {
    const Seen seen({40, 30}, {tilted(30)});
    const Image<float> constant({40, 30}, 0.375f);
    const Image<float> same = blurred(constant, seen, {.tolerance = 0.1f});
    for (const float value : same.pixels()) {
        EXPECT_NEAR(value, 0.375f, 1e-6f);
    }
    Image<float> point({40, 30}, 0);
    point(20, 15) = 1;
    EXPECT_NEAR(mean(blurred(point, seen, {.tolerance = 0.1f})) * 1200, 1, 1e-3);
}

TEST(BlurStep, StopsAtEdges) {
    const Seen seen({40, 30}, step_in_depth);
    const Image<float> ones = ones_on(seen, 15);
    EXPECT_EQ(blurred(ones, seen, {.tolerance = 0.5f}), ones);
    const Image<float> bled = blurred(ones, seen, {});
    EXPECT_GT(bled(18, 15), 0.1f) << "a plain gaussian does not";
}

TEST(BlurStep, IsAGaussianWithoutATolerance) {
    const Seen seen({40, 30}, {tilted(0)});
    Image<float> line({40, 30}, 0), out({40, 30});
    line(20, 15) = 1;
    steps.blur(line.view(), seen.buffer(), {}, Axis::x, {0, 0, 40, 30}, out.view());
    double whole = 0;
    for (int i = -4; i <= 4; ++i) whole += std::exp(-i * i / 4.5);
    for (int i = -5; i <= 5; ++i) {
        const double expected = std::abs(i) > 4 ? 0 : std::exp(-i * i / 4.5) / whole;
        EXPECT_NEAR(out(20 + i, 15), expected, 1e-6) << i;
    }
    EXPECT_EQ(out(20, 14), 0);
}

TEST(BlurStep, SpreadsNoNaNAndNoSky) {
    const Seen seen({40, 30}, {{{0, 0, -1}, -10, 0}});
    Image<float> in({40, 30}, 0.5f);
    in(30, 15) = std::nanf("");
    in(19, 15) = 77;  // in the sky
    const Image<float> out = blurred(in, seen, {});
    EXPECT_TRUE(std::isnan(out(30, 15)));
    EXPECT_EQ(out(19, 15), 77);
    EXPECT_NEAR(out(29, 15), 0.5f, 1e-6f);
    EXPECT_NEAR(out(20, 15), 0.5f, 1e-6f);
}

TEST(Upsample, KeepsEachSideOfAnEdge) {
    const Seen fine({41, 31}, step_in_depth);
    Seen coarse({21, 16}, {});
    each_pixel({0, 0, 21, 16}, [&](int x, int y) {
        coarse.depth(x, y) = fine.depth(2 * x, 2 * y);
        coarse.position(x, y) = fine.position(2 * x, 2 * y);
    });
    const Image<float> ones = ones_on(coarse, 15), expected = ones_on(fine, 15);
    Image<float> out(fine.depth.size(), -1);
    steps.upsample(ones.view(), coarse.buffer(), fine.buffer(), 0.5f, {0, 0, 41, 31}, out.view());
    EXPECT_EQ(out, expected);
}

TEST(Upsample, IsBilinearOnAPlane) {
    const Seen fine({9, 9}, {tilted(20)});
    Seen coarse({5, 5}, {});
    Image<float> ramp({5, 5});
    each_pixel({0, 0, 5, 5}, [&](int x, int y) {
        coarse.position(x, y) = fine.position(2 * x, 2 * y);
        ramp(x, y) = static_cast<float>(4 * x + y);
    });
    Image<float> out({9, 9});
    steps.upsample(ramp.view(), coarse.buffer(), fine.buffer(), 1, {0, 0, 9, 9}, out.view());
    each_pixel({0, 0, 9, 9}, [&](int x, int y) {
        EXPECT_NEAR(out(x, y), 2.0f * float(x) + 0.5f * float(y), 1e-4f) << x << "," << y;
    });
}

TEST(Apply, MultipliesTheAmbientLight) {
    Image<float> visibility({2, 1});
    visibility.pixels() = {1, 0.25f};
    Image<Rgb> light({2, 1});
    steps.apply(visibility.view(), Rgb(0.4f, 0.8f, 1), {0, 0, 2, 1}, light.view());
    EXPECT_EQ(light(0, 0), Rgb(0.4f, 0.8f, 1));
    EXPECT_EQ(light(1, 0), Rgb(0.1f, 0.2f, 0.25f));
}

}  // namespace
}  // namespace luch::techniques::ssao
