// Tasks t1 and t2: from directions to texels and back.
#include "framework/grading/gates.h"
#include "homework/shadow_map/check/same.h"
#include "homework/shadow_map/check/tests.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace luch::homework::shadow_map {
namespace {

using grading::Finding;

constexpr float infinite = std::numeric_limits<float>::infinity();

std::vector<Texel> texels(const Steps& steps, std::span<const Vec3> directions, int n) {
    std::vector<Texel> found(directions.size(), Texel{-1, -1, -1});
    steps.texel_of(directions, n, found);
    return found;
}

Finding faces_and_cells(const Steps& steps, const Sample& sample) {
    return same_texels(texels(steps, sample.directions, sample.map.n), sample.texels, "direction");
}

Finding through_centres(const Steps& steps, const Sample& sample) {
    return same_texels(texels(steps, sample.centres, sample.map.n), sample.texels, "centre");
}

/// As long as an atom and as a galaxy.
Finding any_length(const Steps& steps, const Sample& sample) {
    std::vector<Vec3> tiny = sample.directions, huge = sample.directions;
    for (Vec3& direction : tiny) direction *= 1e-24f;
    for (Vec3& direction : huge) direction *= 1e24f;
    return grading::first_failure_of(
        {same_texels(texels(steps, tiny, sample.map.n), sample.texels, "short direction"),
         same_texels(texels(steps, huge, sample.map.n), sample.texels, "long direction")});
}

/// Edges and corners of the cube, and what is no direction.
Finding odd_directions(const Steps& steps, const Sample& sample) {
    const int n = sample.map.n, last = n - 1, middle = n / 2, higher = 5 * n / 8;
    const float none = std::nanf("");
    const std::vector<Vec3> directions{
        {1, 1, 1},  {-1, 1, -1},   {0, 2, 2},         {0, -3, 3},   {-4, 1, 4},
        {4, 4, 1},  {-2, -2, 0},   {0, 0, 0},         {none, 1, 0}, {infinite, 1, 1},
        {0, 0, -8}, {0, -1, none}, {2, -infinite, 0}, {-1, -1, -1}, {-0.0f, -0.0f, 5}};
    const std::vector<Texel> expected{
        {0, last, last},     {1, last, 0},        {2, last, middle},   {3, last, middle},
        {1, higher, last},   {0, last, higher},   {1, 0, middle},      {0, middle, middle},
        {0, middle, middle}, {0, middle, middle}, {5, middle, middle}, {0, middle, middle},
        {0, middle, middle}, {1, 0, 0},           {4, middle, middle}};
    return same_texels(texels(steps, directions, n), expected, "odd direction");
}

std::vector<Vec3> directions(const Steps& steps, const Sample& sample) {
    std::vector<Vec3> found(sample.texels.size(), Vec3(7));
    steps.direction_of(sample.texels, sample.map.n, found);
    return found;
}

/// Whatever their length.
Finding where_to(const Steps& steps, const Sample& sample) {
    std::vector<double> got, expected;
    for (const Vec3& d : directions(steps, sample)) {
        const Vec3d unit = glm::normalize(Vec3d(d));
        for (int k = 0; k < 3; ++k) got.push_back(std::isnan(unit[k]) ? -1e300 : unit[k]);
    }
    for (const Vec3& d : sample.centres) expected.insert(expected.end(), {d.x, d.y, d.z});
    Finding finding = grading::same_numbers(got, expected, 1e-5, "the direction of texel", 3);
    if (finding.passed || finding.wrong.empty()) return finding;
    const std::size_t first = finding.wrong.front();
    const auto& [face, x, y] = sample.texels[first];
    finding.first = fmt::format(
        "texel {{{}, {}, {}}} expected ({:.5g}, {:.5g}, {:.5g}), got ({:.5g}, {:.5g}, {:.5g})",
        face, x, y, expected[3 * first], expected[3 * first + 1], expected[3 * first + 2],
        got[3 * first], got[3 * first + 1], got[3 * first + 2]);
    return finding;
}

Finding unit_length(const Steps& steps, const Sample& sample) {
    std::vector<double> got;
    for (const Vec3& d : directions(steps, sample)) {
        const double length = glm::length(Vec3d(d));
        got.push_back(std::isnan(length) ? -1 : length);
    }
    return grading::same_numbers(got, std::vector<double>(got.size(), 1.0), 1e-5,
                                 "the length of direction");
}

}  // namespace

std::vector<grading::Case> cases_of(const Samples& samples, SampleTest test) {
    std::vector<grading::Case> cases;
    for (const auto& sample : samples) {
        cases.push_back({sample->name, sample->scene_file, [sample, test](const std::any& steps) {
                             return test(steps_in(steps), *sample);
                         }});
    }
    return cases;
}

grading::Task texel_task(const Samples& samples) {
    return {"shadow_map.t1",
            "texel_of: which texel does a direction go through?",
            {{"shadow_map.t1.faces_and_cells", 2, cases_of(samples, faces_and_cells)},
             {"shadow_map.t1.through_centres", 0.5, cases_of(samples, through_centres)},
             {"shadow_map.t1.odd_directions", 1, cases_of(samples, odd_directions)},
             {"shadow_map.t1.any_length", 0.5, cases_of(samples, any_length)}}};
}

grading::Task direction_task(const Samples& samples) {
    return {"shadow_map.t2",
            "direction_of: through the middle of a texel",
            {{"shadow_map.t2.where_to", 1.5, cases_of(samples, where_to)},
             {"shadow_map.t2.unit_length", 0.5, cases_of(samples, unit_length)}}};
}

}  // namespace luch::homework::shadow_map
