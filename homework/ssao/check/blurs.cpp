// Tasks t5 to t7: smoothing, upsampling, light.
#include "framework/grading/gates.h"
#include "homework/ssao/check/made.h"
#include "homework/ssao/check/same.h"
#include "homework/ssao/check/tests.h"

#include <cmath>

namespace luch::homework::ssao {
namespace {

using grading::Finding;

constexpr float infinite = std::numeric_limits<float>::infinity();

Image<float> blurred(const Steps& steps, const Image<float>& in, const GBuffer& seen,
                     const Blur& blur, Axis axis) {
    Image<float> out(in.size(), -7);
    steps.blur(in.view(), seen, blur, axis, in.view().tile(), out.view());
    return out;
}

Finding along_x(const Steps& steps, const Sample& sample) {
    return same_plane(
        blurred(steps, sample.raw, sample.seen(), {.tolerance = Sample::tolerance}, Axis::x),
        sample.along_x, "the occlusion of pixel");
}

Finding along_y(const Steps& steps, const Sample& sample) {
    return same_plane(
        blurred(steps, sample.raw, sample.seen(), {.tolerance = Sample::tolerance}, Axis::y),
        sample.along_y, "the occlusion of pixel");
}

/// 1 left of a column.
Image<float> ones_until(Size size, int column) {
    Image<float> image(size, 0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < column; ++x) image(x, y) = 1;
    }
    return image;
}

/// Two boards, one far in front of the other: what is dark stays on its side.
Finding up_to_edges(const Steps& steps, const Sample&) {
    const Made made({facing(20), facing(10, 0)});
    const Image<float> ones = ones_until(made.depth.size(), 24);
    const Image<float> constant(ones.size(), 0.375f);
    return grading::first_failure_of(
        {same_plane(blurred(steps, ones, made.seen(), {.tolerance = 0.5f}, Axis::x), ones,
                    "beside the edge, the occlusion of pixel"),
         same_plane(blurred(steps, constant, made.seen(), {.tolerance = 0.5f}, Axis::x), constant,
                    "of a constant, the occlusion of pixel")});
}

/// Without a tolerance it is the lecture's gaussian.
Finding plain_gaussian(const Steps& steps, const Sample&) {
    const Made made({facing(20), facing(10, 0)});
    Image<float> in(made.depth.size(), 0), expected = in;
    in(24, 18) = 1;
    constexpr int reach = 3;
    constexpr double sigma = 1.25;
    double whole = 0;
    for (int i = -reach; i <= reach; ++i) whole += std::exp(-0.5 * i * i / (sigma * sigma));
    for (int i = -reach; i <= reach; ++i) {
        expected(24 + i, 18) = static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)) / whole);
    }
    const Blur blur{.sigma_px = static_cast<float>(sigma), .reach_px = reach};
    return same_plane(blurred(steps, in, made.seen(), blur, Axis::x), expected,
                      "the occlusion of pixel");
}

/// Pixels that are not finite, or of the sky, stay alone.
Finding not_spread(const Steps& steps, const Sample&) {
    const Made made({facing(10, 0)});
    Image<float> in(made.depth.size(), 0.5f);
    in(11, 8) = 77;  // in the sky
    in(22, 12) = 77;
    in(30, 17) = std::nanf("");
    in(36, 9) = infinite;
    return grading::first_failure_of(
        {same_plane(blurred(steps, in, made.seen(), {}, Axis::x), in, "the occlusion of pixel"),
         same_plane(blurred(steps, in, made.seen(), {.tolerance = 0.2f}, Axis::y), in,
                    "the occlusion of pixel")});
}

Image<float> upsampled(const Steps& steps, const Image<float>& raw, const Image<Vec3>& position,
                       const Image<Vec3>& normal, float tolerance) {
    const Image<float> coarse = halved(raw);
    const Image<Vec3> at = halved(position), facing_to = halved(normal);
    Image<float> out(raw.size(), -7);
    steps.upsample(coarse.view(), {at.view(), facing_to.view()}, {position.view(), normal.view()},
                   tolerance, raw.view().tile(), out.view());
    return out;
}

Finding up(const Steps& steps, const Sample& sample) {
    return same_plane(
        upsampled(steps, sample.raw, sample.position, sample.normal, Sample::tolerance),
        sample.upsampled, "the occlusion of pixel");
}

/// A ramp on a wall stays one: the pixels stand where they should.
Finding ramps(const Steps& steps, const Sample& sample) {
    const Made made({tilted(30, 50)}, {sample.depth.width() + 1, sample.depth.height() + 1});
    Image<float> ramp(made.depth.size());
    for (int y = 0; y < ramp.height(); ++y) {
        for (int x = 0; x < ramp.width(); ++x) {
            ramp(x, y) = 0.01f * static_cast<float>(x) + 0.005f * static_cast<float>(y);
        }
    }
    return same_plane(upsampled(steps, ramp, made.position, made.normal, 1), ramp,
                      "of a ramp, pixel");
}

Finding up_edges(const Steps& steps, const Sample&) {
    const Made made({facing(20), facing(10, 0)}, {46, 36});
    const Image<float> ones = ones_until(made.depth.size(), 23);
    // A wire that the small picture does not have takes what is least far from it.
    Made wire = made;
    for (int y = 0; y < 36; ++y) wire.position(23, y) *= 0.5f;
    Image<float> right(ones.size());
    for (std::size_t i = 0; i < right.pixels().size(); ++i) {
        right.pixels()[i] = 1 - ones.pixels()[i];
    }
    return grading::first_failure_of(
        {same_plane(upsampled(steps, ones, made.position, made.normal, 0.5f), ones,
                    "beside the edge, pixel"),
         same_plane(upsampled(steps, right, wire.position, wire.normal, 0.5f), right,
                    "on a wire, pixel")});
}

Image<Rgb> applied(const Steps& steps, const Image<float>& visibility, const Rgb& ambient) {
    Image<Rgb> light(visibility.size(), Rgb(-7));
    steps.apply(visibility.view(), ambient, visibility.view().tile(), light.view());
    return light;
}

Finding arriving(const Steps& steps, const Sample& sample) {
    Image<float> visibility = sample.raw;
    for (float& share : visibility.pixels()) share = 1 - share;
    return same_vectors(applied(steps, visibility, sample.ambient()), sample.light,
                        "the light at pixel");
}

Finding coloured(const Steps& steps, const Sample& sample) {
    const Image<float> visibility(sample.depth.size(), 0.5f);
    return same_vectors(applied(steps, visibility, {0.25f, 2, 40}),
                        Image<Rgb>(visibility.size(), Rgb(0.125f, 1, 20)), "the light at pixel");
}

}  // namespace

grading::Task blur_task(const Samples& samples) {
    return {"ssao.t5",
            "blur: within surfaces",
            {{"ssao.t5.along_x", 1, cases_of(samples, along_x)},
             {"ssao.t5.along_y", 1, cases_of(samples, along_y)},
             {"ssao.t5.up_to_edges", 1, cases_of(samples, up_to_edges)},
             {"ssao.t5.plain_gaussian", 1, cases_of(samples, plain_gaussian)},
             {"ssao.t5.not_spread", 1, cases_of(samples, not_spread)}}};
}

grading::Task upsample_task(const Samples& samples) {
    return {"ssao.t6",
            "upsample: from half resolution",
            {{"ssao.t6.upsampled", 2, cases_of(samples, up)},
             {"ssao.t6.ramps", 1, cases_of(samples, ramps)},
             {"ssao.t6.up_to_edges", 1, cases_of(samples, up_edges)}}};
}

grading::Task apply_task(const Samples& samples) {
    return {"ssao.t7",
            "apply: the light that arrives",
            {{"ssao.t7.arriving", 1, cases_of(samples, arriving)},
             {"ssao.t7.coloured", 1, cases_of(samples, coloured)}}};
}

}  // namespace luch::homework::ssao
