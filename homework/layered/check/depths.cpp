// Tasks t1 and t2: how a scene is cut into layers, and how blurred each depth is.
#include "framework/grading/gates.h"
#include "homework/layered/check/same.h"
#include "homework/layered/check/tests.h"

#include <limits>

namespace luch::homework::layered {
namespace {

using grading::Finding;

constexpr float infinite = std::numeric_limits<float>::infinity();

const Steps& steps_in(const std::any& steps) {
    return *std::any_cast<Steps>(&steps);
}

/// Cuts as 1/z, where an infinite one is a number like others.
Finding same_cuts(const std::vector<float>& yours, const std::vector<float>& reference) {
    std::vector<double> got, expected;
    for (const float cut : yours) got.push_back(1 / double(cut));
    for (const float cut : reference) expected.push_back(1 / double(cut));
    return grading::same_numbers(got, expected, 1e-5, "the inverse of cut");
}

std::vector<float> cut(const Steps& steps, const std::vector<float>& depths, int k) {
    std::vector<float> cuts(static_cast<std::size_t>(k - 1), -1);
    steps.cut(depths, k, cuts);
    return cuts;
}

Finding equal_layers(const Steps& steps, const Sample& sample) {
    return same_cuts(cut(steps, sample.depth.pixels(), cut_layers), sample.cuts);
}

/// Sky, nothing and nonsense among the depths.
Finding odd_depths(const Steps& steps, const Sample& sample) {
    std::vector<float> depths = sample.depth.pixels();
    const float nearest = 1 / (2 / sample.cuts[0] - 1 / sample.cuts[1]);
    std::erase_if(depths, [](float z) { return z == infinite; });
    depths.push_back(-1);
    depths.push_back(infinite);
    depths.push_back(0);
    depths.push_back(std::nanf(""));
    return grading::first_failure_of(
        {same_cuts(cut(steps, depths, 3), {1.5f * nearest, 3 * nearest}),
         same_cuts(cut(steps, {0, -2}, 3), {infinite, infinite})});
}

Finding circles(const Steps& steps, const Sample& sample) {
    Image<float> px(sample.depth.size(), -1);
    steps.coc(sample.depth.view(), sample.lens(), sample.depth.view().tile(), px.view());
    return same_plane(px, sample.coc, "the circle of confusion of pixel");
}

/// In steps from the lens to the sky, with what must not happen at both ends.
Finding both_ends(const Steps& steps, const Sample& sample) {
    const Lens lens = sample.lens();
    const double far = 2 * lens.radius * lens.px_per_unit / lens.focal_distance;
    const auto focus = static_cast<float>(lens.focal_distance);
    Image<float> z({6, 1}), px({6, 1}), expected({6, 1});
    z.pixels() = {0, -1, 1e-20f, focus, infinite, 2 * focus};
    const float most = lens.largest_px;
    expected.pixels() = {most, most, most, 0, float(far), float(far / 2)};
    steps.coc(z.view(), lens, {0, 0, 6, 1}, px.view());
    return same_plane(px, expected, "the circle of confusion of depth");
}

Finding in_tiles(const Steps& steps, const Sample& sample) {
    Image<float> px(sample.depth.size(), -1), expected = px;
    const Tile tile{7, 5, 23, 21};
    steps.coc(sample.depth.view(), sample.lens(), tile, px.view());
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) expected(x, y) = sample.coc(x, y);
    }
    return same_plane(px, expected, "what was written of pixel");
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

grading::Task cut_task(const Samples& samples) {
    return {"layered.t1",
            "cut: layers of equal blur",
            {{"layered.t1.equal_layers", 2, cases_of(samples, equal_layers)},
             {"layered.t1.odd_depths", 1, cases_of(samples, odd_depths)}}};
}

grading::Task coc_task(const Samples& samples) {
    return {"layered.t2",
            "coc: the circle of confusion",
            {{"layered.t2.circles", 2, cases_of(samples, circles)},
             {"layered.t2.both_ends", 1, cases_of(samples, both_ends)},
             {"layered.t2.in_tiles", 1, cases_of(samples, in_tiles)}}};
}

}  // namespace luch::homework::layered
