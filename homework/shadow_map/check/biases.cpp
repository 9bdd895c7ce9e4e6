// Task t4: how much nearer than a receiver its texel's centre may be.
#include "framework/grading/gates.h"
#include "homework/shadow_map/check/same.h"
#include "homework/shadow_map/check/tests.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace luch::homework::shadow_map {
namespace {

using grading::failure;
using grading::Finding;

constexpr float infinite = std::numeric_limits<float>::infinity();

std::vector<float> biases(const Steps& steps, std::span<const Receiver> receivers, int n) {
    std::vector<float> found(receivers.size(), -1);
    steps.bias(receivers, n, found);
    return found;
}

double distance_of(const Receiver& receiver) {
    return glm::length(Vec3d(receiver.from_light));
}

/// Held in units of what is expected, and a little of the distance: float has its rounding.
Finding same_biases(std::span<const float> yours, std::span<const float> reference,
                    std::span<const Receiver> receivers) {
    std::vector<double> got, expected;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        const double unit = reference[i] + 1e-4 * distance_of(receivers[i]);
        got.push_back(std::isfinite(yours[i]) ? yours[i] / unit : -1e300);
        expected.push_back(reference[i] / unit);
    }
    Finding finding = grading::same_numbers(got, expected, 2e-3, "the bias of receiver");
    if (finding.passed || finding.wrong.empty()) return finding;
    const std::size_t first = finding.wrong.front();
    finding.first = fmt::format("the bias of receiver {} expected {:.5g}, got {:.5g}", first,
                                reference[first], yours[first]);
    return finding;
}

/// What the camera sees.
Finding of_the_scene(const Steps& steps, const Sample& sample) {
    const std::vector<float> yours = biases(steps, sample.seen.points, sample.map.n);
    Finding finding = same_biases(yours, sample.seen.biases, sample.seen.points);
    if (finding.passed || finding.wrong.empty()) return finding;
    const int pixel = static_cast<int>(sample.pixels[finding.wrong.front()]);
    const int width = sample.scene->settings.frame.width;
    finding.pixel = fmt::format("{},{}", pixel % width, pixel / width);
    finding.first = fmt::format("({}): {}", finding.pixel, finding.first);
    return finding;
}

/// Planes at random through what directions point to.
std::vector<Receiver> on_planes(const Sample& sample) {
    std::vector<Receiver> receivers;
    for (std::size_t i = 0; i < sample.directions.size(); ++i) {
        const Key key = Key(17).branch(i);
        const Vec3d normal(2 * key.uniform(0) - 1, 2 * key.uniform(1) - 1, 2 * key.uniform(2) - 1);
        receivers.push_back(
            {Vec3((1 + 9 * key.uniform(3)) * glm::normalize(Vec3d(sample.directions[i]))),
             Vec3(glm::normalize(normal))});
    }
    return receivers;
}

/// What is stored for a plane is its distance along the texel's centre. Where that falls short of
/// the receiver's, the bias must make up for it, but not for more than twice as much everywhere.
Finding neither_acne_nor_gap(const Steps& steps, const Sample& sample) {
    const std::vector<Receiver> receivers = on_planes(sample);
    const std::vector<float> yours = biases(steps, receivers, sample.map.n);
    Finding finding;
    std::size_t needed = 0;
    for (std::uint32_t i = 0; i < receivers.size(); ++i) {
        const Vec3d normal(receivers[i].normal), p(receivers[i].from_light);
        const double stored = glm::dot(normal, p) / glm::dot(normal, Vec3d(sample.centres[i]));
        const double shortfall = distance_of(receivers[i]) - stored;
        if (!(stored > 0)) continue;  // the centre looks past the plane
        needed += shortfall > 0.5 * yours[i] ? 1 : 0;
        if (shortfall <= 1.01 * yours[i] + 1e-6 * distance_of(receivers[i])) continue;
        if (finding.wrong.empty()) {
            finding.first = fmt::format(
                "receiver {}: the texel's centre is nearer by {:.5g}, the bias is {:.5g}", i,
                shortfall, yours[i]);
        }
        finding.wrong.push_back(i);
    }
    finding.passed = finding.wrong.empty();
    finding.what = fmt::format("{} of {} receivers shade themselves: acne", finding.wrong.size(),
                               receivers.size());
    if (finding.passed && needed < receivers.size() / 50) {
        return failure("half of the bias would do for nearly all: light leaks in under things",
                       fmt::format("expected at least {} of {} receivers to need more, got {}",
                                   receivers.size() / 50, receivers.size(), needed));
    }
    return finding;
}

/// Either side of a surface; every distance; every n.
Finding of_one_kind(const Steps& steps, const Sample& sample) {
    std::vector<Receiver> receivers = on_planes(sample), turned = receivers, far = receivers;
    std::erase_if(receivers, [](const Receiver& each) {
        return std::abs(glm::dot(each.normal, each.from_light)) < 0.01 * distance_of(each);
    });
    turned = far = receivers;
    for (Receiver& each : turned) each.normal = -each.normal;
    for (Receiver& each : far) each.from_light *= 4096;
    const int n = sample.map.n;
    const std::vector<float> here = biases(steps, receivers, n);
    std::vector<float> there = biases(steps, far, n), finer = biases(steps, receivers, 8 * n);
    for (float& each : there) each /= 4096;
    // Whatever is left for rounding is not at stake here.
    for (std::size_t i = 0; i < finer.size(); ++i) {
        const auto rounding = static_cast<float>(rounding_share * distance_of(receivers[i]));
        finer[i] = std::clamp(here[i], 8 * (finer[i] - rounding), 8 * finer[i]);
    }
    const auto named = [](Finding finding, const char* what) {
        if (!finding.passed) finding.what = what;
        return finding;
    };
    return grading::first_failure_of(
        {named(same_biases(biases(steps, turned, n), here, receivers),
               "a surface has not the same bias on both sides"),
         named(same_biases(there, here, receivers), "the bias does not grow with the distance"),
         named(same_biases(finer, here, receivers), "the bias does not shrink with the texels")});
}

/// In the light, edge on, and facing it.
Finding at_the_ends(const Steps& steps, const Sample& sample) {
    const std::vector<Receiver> receivers{{Vec3(0), {0, 1, 0}},
                                          {{2, 0, 0}, {0, 1, 0}},
                                          {{0, -3, 0}, {0, 1, 0}},
                                          {{0, 0, 512}, {0, 0, 1}},
                                          {{1, -1, 0}, {0, 0, 1}},
                                          {{0.125f, 0, 0}, {-1, 0, 0}},
                                          {{-4, 4, -4}, {0, 0.70710678f, 0.70710678f}}};
    const std::vector<float> expected{0,
                                      infinite,
                                      3 * rounding_share,
                                      512 * rounding_share,
                                      infinite,
                                      0.125f * rounding_share,
                                      infinite};
    const std::vector<float> yours = biases(steps, receivers, sample.map.n);
    Finding finding;
    for (std::uint32_t i = 0; i < yours.size(); ++i) {
        const bool same = std::isfinite(expected[i])
                              ? std::abs(yours[i] - expected[i]) <= 0.1f * expected[i]
                              : yours[i] == expected[i];
        if (same) continue;
        if (finding.wrong.empty()) {
            const Vec3 &p = receivers[i].from_light, &normal = receivers[i].normal;
            finding.first = fmt::format(
                "from_light ({:g}, {:g}, {:g}), normal ({:g}, {:g}, {:g}): expected {:.5g}, got "
                "{:.5g}",
                p.x, p.y, p.z, normal.x, normal.y, normal.z, expected[i], yours[i]);
        }
        finding.wrong.push_back(i);
    }
    finding.passed = finding.wrong.empty();
    finding.what = "in the light, edge on, or facing it, the bias is wrong";
    return finding;
}

}  // namespace

grading::Task bias_task(const Samples& samples) {
    return {"shadow_map.t4",
            "bias: as much as geometry asks for",
            {{"shadow_map.t4.of_the_scene", 1.5, cases_of(samples, of_the_scene)},
             {"shadow_map.t4.neither_acne_nor_gap", 1, cases_of(samples, neither_acne_nor_gap)},
             {"shadow_map.t4.of_one_kind", 0.5, cases_of(samples, of_one_kind)},
             {"shadow_map.t4.at_the_ends", 1, cases_of(samples, at_the_ends)}}};
}

}  // namespace luch::homework::shadow_map
