// Tasks t3, t4 and t5: what becomes of triangles on their way to the screen.
#include "framework/grading/gates.h"
#include "homework/vista/check/sight.h"
#include "homework/vista/check/tests.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace luch::homework::vista {
namespace {

using grading::failure;
using grading::Finding;

std::vector<Tri> clipped(const Steps& steps, const Sample& sample) {
    std::vector<Tri> inside{{}};  // what was there before is replaced
    steps.clip(sample.around, frustum_of(sample.screen()), inside);
    return inside;
}

/// Nothing that is seen may be lost, and nothing may be there twice.
Finding cut_by_the_frame(const Steps& steps, const Sample& sample) {
    const Sight before = sight_of(sample.around, sample.screen());
    const Sight after = sight_of(clipped(steps, sample), sample.screen());
    return grading::first_failure_of(
        {grading::same_ids(after.ids.view(), before.ids.view()),
         grading::same_depths(after.depth.view(), before.depth.view(), after.ids.view(),
                              before.ids.view()),
         grading::same_ids(after.layers.view(), before.layers.view(), "number of triangles")});
}

/// How far a corner is outside, as a part of its distance from the eye; 0 when inside.
double outside(const Corner& corner, const Frustum& frustum) {
    double most = 0;
    for (const Vec3d& inward : frustum.inward) {
        const double scale = glm::length(inward) * glm::length(corner.p);
        most = std::max(most, -glm::dot(inward, corner.p) / scale);
    }
    return most;
}

Finding nothing_outside(const Steps& steps, const Sample& sample) {
    constexpr double rounding = 1e-6;
    const Frustum frustum = frustum_of(sample.screen());
    const std::vector<Tri> inside = clipped(steps, sample);
    Finding finding;
    for (std::uint32_t i = 0; i < inside.size(); ++i) {
        for (const Corner& corner : inside[i].corners) {
            if (outside(corner, frustum) <= rounding) continue;
            if (finding.wrong.empty()) {
                finding.first = fmt::format(
                    "triangle {} of node {}: a corner at ({:.4g}, {:.4g}, "
                    "{:.4g})",
                    i, inside[i].node, corner.p.x, corner.p.y, corner.p.z);
            }
            if (finding.wrong.empty() || finding.wrong.back() != i) finding.wrong.push_back(i);
        }
    }
    finding.passed = finding.wrong.empty();
    finding.what = fmt::format("{} of {} triangles reach out of the view volume",
                               finding.wrong.size(), inside.size());
    return finding;
}

Finding keeps_what_is_inside(const Steps& steps, const Sample& sample) {
    const Frustum frustum = frustum_of(sample.screen());
    const std::vector<Tri> inside = clipped(steps, sample);
    Finding finding;
    for (std::uint32_t i = 0; i < sample.around.size(); ++i) {
        const Tri& triangle = sample.around[i];
        const bool untouched =
            std::all_of(triangle.corners.begin(), triangle.corners.end(), [&](const Corner& c) {
                return std::all_of(frustum.inward.begin(), frustum.inward.end(),
                                   [&](const Vec3d& in) { return glm::dot(in, c.p) > 0; });
            });
        if (!untouched || std::count(inside.begin(), inside.end(), triangle) == 1) continue;
        if (finding.wrong.empty()) {
            finding.first =
                fmt::format("triangle {} of node {}: expected as it was, once", i, triangle.node);
        }
        finding.wrong.push_back(i);
    }
    finding.passed = finding.wrong.empty();
    finding.what =
        fmt::format("{} triangles that lie inside are changed or lost", finding.wrong.size());
    return finding;
}

double farthest(const Tri& triangle) {
    double most = 0;
    for (const auto& [p, w] : triangle.corners) {
        most = std::max(most, w > 0 ? glm::length(p) / w : std::numeric_limits<double>::infinity());
    }
    return most;
}

/// Distances, not triangles, are compared: those which differ by rounding may change places.
Finding far_to_near(const Steps& steps, const Sample& sample) {
    std::vector<Tri> yours = sample.in_view;
    steps.sort(yours);
    const std::vector<Tri> reference = sample.sorted();
    for (const Tri& triangle : yours) {
        if (std::find(reference.begin(), reference.end(), triangle) == reference.end()) {
            return failure("a triangle came out that did not go in");
        }
    }
    std::vector<double> got, expected;
    for (const Tri& triangle : yours) got.push_back(farthest(triangle));
    for (const Tri& triangle : reference) expected.push_back(farthest(triangle));
    return grading::same_numbers(got, expected, 1e-6, "the distance of triangle");
}

/// Every triangle three times, of nodes that count up: they must come out counting up.
Finding keeps_the_order_of_equals(const Steps& steps, const Sample& sample) {
    std::vector<Tri> triangles;
    for (int time = 0; time < 3; ++time) {
        for (Tri triangle : sample.in_view) {
            triangle.node = static_cast<NodeId>(triangles.size());
            triangles.push_back(triangle);
        }
    }
    steps.sort(triangles);
    Finding finding;
    for (std::uint32_t i = 1; i < triangles.size(); ++i) {
        const Tri& one = triangles[i - 1];
        const Tri& next = triangles[i];
        if (one.corners != next.corners || one.node < next.node) continue;
        if (finding.wrong.empty()) {
            finding.first =
                fmt::format("place {}: number {} after number {}", i, next.node, one.node);
        }
        finding.wrong.push_back(i);
    }
    finding.passed = finding.wrong.empty();
    finding.what =
        fmt::format("{} triangles at the same distance have changed places", finding.wrong.size());
    return finding;
}

std::vector<ScreenTri> projected(const Steps& steps, std::span<const Tri> triangles,
                                 const Screen& screen) {
    std::vector<ScreenTri> result(triangles.size());
    steps.project(triangles, screen, result);
    return result;
}

Finding on_the_right_pixels(const Steps& steps, const Sample& sample) {
    std::vector<double> got, expected;
    const double grid = pixel_grid(sample.screen().size());
    for (const ScreenTri& triangle : projected(steps, sample.sorted(), sample.screen())) {
        for (const Vec2d& px : triangle.px) {
            got.insert(got.end(), {px.x, px.y});
            if (px == glm::round(px / grid) * grid) continue;
            return failure("a corner is not on the pixel_grid()",
                           fmt::format("({:.9g}, {:.9g})", px.x, px.y));
        }
    }
    for (const ScreenTri& triangle : sample.on_screen) {
        for (const Vec2d& px : triangle.px) expected.insert(expected.end(), {px.x, px.y});
    }
    return grading::same_numbers(got, expected, 1e-4, "the place of triangle", 6);
}

Finding inverse_depths(const Steps& steps, const Sample& sample) {
    std::vector<double> got, expected;
    const auto add = [](std::vector<double>& list, const ScreenTri& triangle) {
        list.insert(list.end(), triangle.inverse_depth.begin(), triangle.inverse_depth.end());
    };
    for (const ScreenTri& each : projected(steps, sample.sorted(), sample.screen())) add(got, each);
    for (const ScreenTri& each : sample.on_screen) add(expected, each);
    return grading::same_numbers(got, expected, 1e-6, "the 1/z of triangle", 3);
}

/// A point on the ray through a place on the screen falls on that place, wherever on the ray.
Finding undoes_screen_ray(const Steps& steps, const Sample& sample) {
    const Screen screen = sample.screen();
    std::vector<Tri> triangles;
    std::vector<double> got, expected;
    for (int i = 0; i < 60; ++i) {
        const double x = 7.13 * i - std::floor(7.13 * i / 96) * 96;
        const double y = 3.77 * i - std::floor(3.77 * i / 72) * 72;
        const Vec3d p = screen.to_view(screen.ray(x, y).at(0.3 + i));
        triangles.push_back({{{{p, 1}, {2.0 * p, 1}, {p, 0}}}, 1});
        for (int k = 0; k < 3; ++k) expected.insert(expected.end(), {x, y});
    }
    for (const ScreenTri& triangle : projected(steps, triangles, screen)) {
        for (const Vec2d& px : triangle.px) got.insert(got.end(), {px.x, px.y});
    }
    return grading::same_numbers(got, expected, 1e-4, "the place of point", 6);
}

Finding leaves_out_what_is_behind(const Steps& steps, const Sample& sample) {
    std::vector<Tri> triangles = sample.sorted();
    for (std::size_t i = 0; i < triangles.size(); i += 3) triangles[i].corners[i % 9 / 3].p.z *= -1;
    const std::vector<ScreenTri> got = projected(steps, triangles, sample.screen());
    Finding finding;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const bool empty = got[i] == ScreenTri{};
        if (empty == (i % 3 == 0)) continue;
        if (finding.wrong.empty()) {
            finding.first = fmt::format("triangle {}: expected {}", i,
                                        empty ? "its image" : "ScreenTri{}: a corner is behind");
        }
        finding.wrong.push_back(i);
    }
    finding.passed = finding.wrong.empty();
    finding.what = fmt::format("{} of {} triangles are left out or kept by mistake",
                               finding.wrong.size(), triangles.size());
    return finding;
}

}  // namespace

grading::Task clip_task(const Samples& samples) {
    return {"vista.t3",
            "clip: what is outside the view volume has no place on the screen",
            {{"vista.t3.cut_by_the_frame", 2, cases_of(samples, cut_by_the_frame)},
             {"vista.t3.nothing_outside", 1, cases_of(samples, nothing_outside)},
             {"vista.t3.keeps_what_is_inside", 1, cases_of(samples, keeps_what_is_inside)}}};
}

grading::Task sort_task(const Samples& samples) {
    return {
        "vista.t4",
        "sort: the painter begins with the far",
        {{"vista.t4.far_to_near", 1, cases_of(samples, far_to_near)},
         {"vista.t4.keeps_the_order_of_equals", 1, cases_of(samples, keeps_the_order_of_equals)}}};
}

grading::Task project_task(const Samples& samples) {
    return {"vista.t5",
            "project: getScreenRay, backwards",
            {{"vista.t5.on_the_right_pixels", 2, cases_of(samples, on_the_right_pixels)},
             {"vista.t5.inverse_depths", 1, cases_of(samples, inverse_depths)},
             {"vista.t5.undoes_screen_ray", 0.5, cases_of(samples, undoes_screen_ray)},
             {"vista.t5.leaves_out_what_is_behind", 0.5,
              cases_of(samples, leaves_out_what_is_behind)}}};
}

}  // namespace luch::homework::vista
