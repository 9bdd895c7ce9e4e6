// Task t3: the kernel. It is random, so it is known by what must hold of any that is right.
#include "framework/grading/gates.h"
#include "homework/ssao/check/tests.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace luch::homework::ssao {
namespace {

using grading::Finding;

constexpr std::size_t many = 4096;
/// A mean of honest points is farther off than this many standard errors once in 10⁹ times.
constexpr double sigmas = 6;

/// A stream of its own for every sample.
Key key_of(const Sample& sample) {
    std::uint64_t sum = 0;
    for (const char c : sample.name) sum = 31 * sum + static_cast<unsigned char>(c);
    return Key(sum);
}

std::vector<Vec3> kernel(const Steps& steps, Key key, std::size_t n) {
    std::vector<Vec3> points(n, Vec3(-9));
    steps.kernel(key, points);
    return points;
}

Finding in_the_half_ball(const Steps& steps, const Sample& sample) {
    for (const std::size_t n : {std::size_t{1}, std::size_t{16}, many}) {
        const std::vector<Vec3> points = kernel(steps, key_of(sample), n);
        for (std::size_t i = 0; i < n; ++i) {
            const double length = glm::length(Vec3d(points[i]));
            if (points[i].z >= 0 && length > 0 && length <= 1 + 1e-5) continue;
            Finding finding =
                grading::failure("a point is not in the unit half-ball around +z",
                                 fmt::format("point {} of {}: ({:.3g}, {:.3g}, {:.3g})", i, n,
                                             points[i].x, points[i].y, points[i].z));
            const bool low = points[i].z<0, long_way = length> 1, last = i + 1 == n;
            finding.signature = {1u + (low ? 1u : 0u) + (long_way ? 2u : 0u) + (last ? 4u : 0u)};
            return finding;
        }
    }
    return {};
}

/// Mean of something of all directions, against what it is for the density cos/π.
Finding mean_is(std::span<const Vec3> points, double (*of)(const Vec3d&), double expected,
                double deviation, std::string_view name, std::uint32_t id) {
    double sum = 0;
    for (const Vec3& point : points) sum += of(glm::normalize(Vec3d(point)));
    const double mean = sum / static_cast<double>(points.size());
    const double error = deviation / std::sqrt(static_cast<double>(points.size()));
    if (std::abs(mean - expected) <= sigmas * error) return {};
    Finding finding =
        grading::failure(fmt::format("the mean {} is not that of the density cos/π", name),
                         fmt::format("expected {:.4f}, got {:.4f}", expected, mean));
    finding.signature = {2 * id + (mean > expected ? 1u : 0u)};
    return finding;
}

Finding cosine_density(const Steps& steps, const Sample& sample) {
    const std::vector<Vec3> points = kernel(steps, key_of(sample), many);
    return grading::first_failure_of(
        {mean_is(
             points, [](const Vec3d& d) { return d.x; }, 0, 0.5, "x", 1),
         mean_is(
             points, [](const Vec3d& d) { return d.y; }, 0, 0.5, "y", 2),
         mean_is(
             points, [](const Vec3d& d) { return d.z; }, 2.0 / 3, 0.2358, "cosine", 3),
         mean_is(
             points, [](const Vec3d& d) { return d.z * d.z; }, 0.5, 0.2887, "squared cosine", 4),
         mean_is(
             points, [](const Vec3d& d) { return d.x * d.x - d.y * d.y; }, 0, 0.4083, "x² − y²",
             5)});
}

/// Distances from near to far, not all the same.
Finding spread_out(const Steps& steps, const Sample& sample) {
    int near = 0, far = 0;
    std::set<std::pair<float, float>> places;
    for (const Vec3& point : kernel(steps, key_of(sample), many)) {
        (glm::length(point) < 0.5f ? near : far) += 1;
        places.emplace(point.x, point.y);
    }
    if (places.size() < many * 9 / 10) return grading::failure("points stand in the same place");
    if (near < 80 || far < 80) {
        return grading::failure("the points' distances are all small or all large",
                                fmt::format("{} below ½, {} above", near, far));
    }
    return {};
}

Finding by_its_key(const Steps& steps, const Sample& sample) {
    const Key key = key_of(sample);
    const std::vector<Vec3> first = kernel(steps, key, 32);
    if (kernel(steps, key, 32) != first) {
        return grading::failure("the same key gives other points the second time");
    }
    for (std::uint64_t i = 0; i < 4; ++i) {
        if (kernel(steps, key.branch(i), 32) == first) {
            return grading::failure("another key gives the same points");
        }
    }
    return {};
}

}  // namespace

grading::Task kernel_task(const Samples& samples) {
    return {"ssao.t3",
            "kernel: points of the half-ball",
            {{"ssao.t3.in_the_half_ball", 1, cases_of(samples, in_the_half_ball)},
             {"ssao.t3.cosine_density", 1, cases_of(samples, cosine_density)},
             {"ssao.t3.spread_out", 1, cases_of(samples, spread_out)},
             {"ssao.t3.by_its_key", 1, cases_of(samples, by_its_key)}}};
}

}  // namespace luch::homework::ssao
