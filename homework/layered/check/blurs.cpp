// Tasks t3 and t4: the two kernels.
#include "framework/grading/gates.h"
#include "homework/layered/check/same.h"
#include "homework/layered/check/tests.h"

#include <limits>

namespace luch::homework::layered {
namespace {

using grading::Finding;

constexpr float infinite = std::numeric_limits<float>::infinity();

Image<Rgba> blurred(const Steps& steps, const Image<Rgba>& in, float sigma, Axis axis) {
    Image<Rgba> out(in.size(), Rgba(-1));
    steps.gaussian(in.view(), sigma, axis, in.view().tile(), out.view());
    return out;
}

Image<Rgba> spread(const Steps& steps, const Image<Rgba>& in, const Image<float>& coc) {
    Image<Rgba> out(in.size(), Rgba(-1));
    steps.disc(in.view(), coc.view(), in.view().tile(), out.view());
    return out;
}

Finding along_x(const Steps& steps, const Sample& sample) {
    return same_layers(blurred(steps, sample.near, gaussian_sigma, Axis::x), sample.along_x);
}

Finding along_y(const Steps& steps, const Sample& sample) {
    return same_layers(blurred(steps, sample.near, gaussian_sigma, Axis::y), sample.along_y);
}

/// No blur at all, and one that is larger than the picture: a constant stays.
Finding extreme_sigmas(const Steps& steps, const Sample& sample) {
    const Image<Rgba> constant(sample.near.size(), sample.near(20, 28) + 0.25f);
    return grading::first_failure_of(
        {same_layers(blurred(steps, sample.near, 0, Axis::x), sample.near),
         same_layers(blurred(steps, sample.near, 1e-6f, Axis::y), sample.near),
         same_layers(blurred(steps, constant, 2, Axis::x), constant),
         same_layers(blurred(steps, constant, 1e6f, Axis::y), constant)});
}

/// Pixels that are not finite stay alone; a highlight stays finite.
template <class Blur>
Finding not_spread(const Sample& sample, Blur&& blur) {
    const Image<Rgba> constant(sample.near.size(), Rgba(0.25f, 0.5f, 0.125f, 1));
    Image<Rgba> in = constant;
    in(11, 8).g = infinite;
    in(30, 17).r = std::nanf("");
    return same_layers(blur(in), in);
}

Finding gaussian_not_spread(const Steps& steps, const Sample& sample) {
    return not_spread(
        sample, [&](const Image<Rgba>& in) { return blurred(steps, in, gaussian_sigma, Axis::x); });
}

Finding discs(const Steps& steps, const Sample& sample) {
    return same_layers(spread(steps, sample.near, sample.coc), sample.spread);
}

/// Points of light become even discs of the same energy.
Finding points(const Steps& steps, const Sample& sample) {
    Image<Rgba> in(sample.near.size(), Rgba(0)), expected = in;
    constexpr float diameter = 7;  // 37 pixels' centres are at most 3.5 away
    for (const auto& [x, y] : {std::pair(9, 9), {28, 18}}) {
        in(x, y) = Rgba(3.7f, 37, 7.4f, 1);
        for (int j = -3; j <= 3; ++j) {
            for (int i = -3; i <= 3; ++i) {
                if (i * i + j * j > 12) continue;
                expected(x + i, y + j) = Rgba(0.1f, 1, 0.2f, 1 / 37.0f);
            }
        }
    }
    return same_layers(spread(steps, in, Image<float>(in.size(), diameter)), expected);
}

/// A constant picture stays one, at its borders and whatever the circles.
Finding constant(const Steps& steps, const Sample& sample) {
    const Image<Rgba> in(sample.near.size(), Rgba(0.25f, 0.5f, 0.125f, 1));
    return grading::first_failure_of(
        {same_layers(spread(steps, in, sample.coc), in),
         same_layers(spread(steps, in, Image<float>(in.size(), 9)), in)});
}

/// A sharp half beside a blurred one: the sharp one hands out nothing, and it is what is handed
/// out, not what is collected, that has a size.
Finding sharp_hands_out_nothing(const Steps& steps, const Sample& sample) {
    const Size size = sample.near.size();
    Image<Rgba> in(size, Rgba(0, 0, 1, 1));
    Image<float> coc(size, 8);
    for (int y = 0; y < size.height; ++y) {
        for (int x = size.width / 2; x < size.width; ++x) {
            in(x, y) = Rgba(1, 0, 0, 1);
            coc(x, y) = 0;
        }
    }
    const Image<Rgba> out = spread(steps, in, coc);
    Image<Rgba> expected = out;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width / 2; ++x) expected(x, y) = in(x, y);
    }
    Finding finding = same_layers(out, expected);
    if (!finding.passed) return finding;
    if (!(out(size.width / 2, 15).b > 0)) {
        return grading::failure("the blurred half does not reach over the sharp one");
    }
    return finding;
}

Finding disc_not_spread(const Steps& steps, const Sample& sample) {
    return not_spread(sample, [&](const Image<Rgba>& in) {
        return spread(steps, in, Image<float>(in.size(), 6));
    });
}

}  // namespace

grading::Task gaussian_task(const Samples& samples) {
    return {"layered.t3",
            "gaussian: the lecture's blur",
            {{"layered.t3.along_x", 1, cases_of(samples, along_x)},
             {"layered.t3.along_y", 1, cases_of(samples, along_y)},
             {"layered.t3.extreme_sigmas", 2, cases_of(samples, extreme_sigmas)},
             {"layered.t3.not_spread", 1, cases_of(samples, gaussian_not_spread)}}};
}

grading::Task disc_task(const Samples& samples) {
    return {"layered.t4",
            "disc: what a lens does",
            {{"layered.t4.discs", 2, cases_of(samples, discs)},
             {"layered.t4.points", 1, cases_of(samples, points)},
             {"layered.t4.constant", 1, cases_of(samples, constant)},
             {"layered.t4.sharp_hands_out_nothing", 1, cases_of(samples, sharp_hands_out_nothing)},
             {"layered.t4.not_spread", 1, cases_of(samples, disc_not_spread)}}};
}

}  // namespace luch::homework::layered
