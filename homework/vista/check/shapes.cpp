// Tasks t1 and t2: how round, and which triangles.
#include "framework/grading/gates.h"
#include "homework/vista/check/sight.h"
#include "homework/vista/check/tests.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace luch::homework::vista {
namespace {

using grading::failure;
using grading::Finding;

/// Twice the error that the reference allows, and half of it again in segments, are still honest.
constexpr double most_error_px = 0.25;

/// What is wrong with an answer, in words; "" when nothing is.
std::string complaint(int n, int reference, float radius) {
    if (n < least_segments || n > most_segments) return "is not in 4…128";
    if (n % 2 != 0) return "is odd";
    const double error = double(radius) * (1 - std::cos(std::numbers::pi / n));
    if (!(error <= most_error_px) && n < most_segments) {
        return fmt::format("leaves the outline {:.2g} px off", error);
    }
    if (n > 1.5 * reference + 2) return "is more than is seen";
    return "";
}

Finding round_enough(const Steps& steps, const LodSample& lod, float from, float to) {
    Finding finding;
    for (std::size_t i = 0; i < lod.radii.size(); ++i) {
        const float radius = lod.radii[i];
        if (radius < from || radius > to) continue;
        const int n = steps.lod(Sphere{}, radius);
        const std::string wrong = complaint(n, lod.segments[i], radius);
        if (wrong.empty()) continue;
        if (finding.wrong.empty()) {
            finding.first =
                fmt::format("a radius of {:.4g} px: expected about {}, got {}, which {}", radius,
                            lod.segments[i], n, wrong);
        }
        finding.wrong.push_back(static_cast<std::uint32_t>(i));
    }
    finding.passed = finding.wrong.empty();
    finding.what = fmt::format("{} radii have the wrong number of segments", finding.wrong.size());
    return finding;
}

Finding none_for(const Steps& steps, const Geometry& geometry) {
    for (const float radius : {0.5f, 40.0f, 3000.0f}) {
        const int n = steps.lod(geometry, radius);
        if (n == 0) continue;
        return failure("a shape that is no sphere has segments",
                       fmt::format("a radius of {:g} px: expected 0, got {}", radius, n));
    }
    return {};
}

std::vector<Tri> all_shapes(const Steps& steps, const Sample& sample) {
    std::vector<Tri> all, some;
    for (NodeId node = 0; node < sample.scene->nodes.size(); ++node) {
        const Geometry& geometry = sample.scene->geometries[sample.scene->nodes[node].geometry];
        steps.tessellate(geometry, std::holds_alternative<Sphere>(geometry) ? shape_segments : 0,
                         some);
        to_view(*sample.scene, node, sample.screen(), some);
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

Finding seen_as_the_shapes(const Steps& steps, const Sample& sample) {
    const Sight sight = sight_of(all_shapes(steps, sample), sample.screen());
    return grading::first_failure_of(
        {grading::same_ids(sight.ids.view(), sample.shape_ids.view()),
         grading::same_depths(sight.depth.view(), sample.shape_depth.view(), sight.ids.view(),
                              sample.shape_ids.view())});
}

/// Every edge belongs to two triangles, its ends equal to the last bit.
Finding closed(const Steps& steps, const Geometry& geometry, int segments) {
    std::vector<Tri> triangles;
    steps.tessellate(geometry, segments, triangles);
    if (triangles.empty()) return failure("there are no triangles");
    using Point = std::tuple<double, double, double>;
    std::map<std::pair<Point, Point>, int> edges;
    for (const Tri& triangle : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d& a = triangle.corners[k].p;
            const Vec3d& b = triangle.corners[(k + 1) % 3].p;
            const Point from{a.x, a.y, a.z}, to{b.x, b.y, b.z};
            ++edges[std::minmax(from, to)];
        }
    }
    Finding finding;
    std::uint32_t index = 0;
    for (const auto& [edge, count] : edges) {
        if (count != 2) {
            if (finding.wrong.empty()) {
                const auto [x, y, z] = edge.first;
                finding.first = fmt::format(
                    "the edge at ({:.4g}, {:.4g}, {:.4g}): expected 2 "
                    "triangles, got {}",
                    x, y, z, count);
            }
            finding.wrong.push_back(index);
        }
        ++index;
    }
    finding.passed = finding.wrong.empty();
    finding.what = fmt::format("{} of {} edges do not belong to two triangles",
                               finding.wrong.size(), edges.size());
    return finding;
}

std::vector<grading::Case> lod_cases(const LodSample& lod) {
    const auto between = [lod](float from, float to) {
        return [=](const std::any& steps) { return round_enough(steps_in(steps), lod, from, to); };
    };
    return {{"tiny", "", between(0, 1)},
            {"small", "", between(1, 30)},
            {"large", "", between(30, 500)},
            {"huge", "", between(500, std::numeric_limits<float>::infinity())}};
}

grading::Case none_case(const char* name, Geometry geometry) {
    return {name, "", [geometry = std::move(geometry)](const std::any& steps) {
                return none_for(steps_in(steps), geometry);
            }};
}

grading::Case closed_case(const char* name, Geometry geometry, int segments) {
    return {name, "",
            [=](const std::any& steps) { return closed(steps_in(steps), geometry, segments); }};
}

}  // namespace

std::vector<grading::Case> cases_of(const Samples& samples, SampleTest test) {
    std::vector<grading::Case> cases;
    for (const auto& sample : samples) {
        cases.push_back({sample->name, sample->scene_file,
                         [=](const std::any& steps) { return test(steps_in(steps), *sample); }});
    }
    return cases;
}

grading::Task lod_task(const LodSample& lod) {
    return {
        "vista.t1",
        "lod: how round is round enough?",
        {{"vista.t1.round_enough", 1, lod_cases(lod)},
         {"vista.t1.spheres_only",
          1,
          {none_case("cube", Cube{}), none_case("plane", Plane{}), none_case("mesh", Mesh{})}}}};
}

grading::Task tessellate_task(const Samples& samples) {
    return {"vista.t2",
            "tessellate: triangles that stand for a shape",
            {{"vista.t2.seen_as_the_shapes", 3, cases_of(samples, seen_as_the_shapes)},
             {"vista.t2.closed",
              2,
              {closed_case("least", Sphere{.centre = {1, 2, 3}, .radius = 0.7}, least_segments),
               closed_case("round", Sphere{.centre = {-0.3, 0.1, 9}, .radius = 5}, 30),
               closed_case("cube", Cube{.centre = {0.1, 0.2, 0.7}, .side = 1.3}, 0)}}}};
}

}  // namespace luch::homework::vista
