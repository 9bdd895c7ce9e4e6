// Tasks t5 and t6: what arrives at a receiver.
#include "framework/grading/gates.h"
#include "homework/shadow_map/check/same.h"
#include "homework/shadow_map/check/tests.h"

#include <limits>

namespace luch::homework::shadow_map {
namespace {

using grading::Finding;

constexpr float infinite = std::numeric_limits<float>::infinity();

using Filter = decltype(Steps::lit);

std::vector<float> shares(Filter filter, const CubeMap& map, std::span<const Receiver> receivers,
                          std::span<const float> biases) {
    std::vector<float> found(receivers.size(), -1);
    filter(map, receivers, biases, found);
    return found;
}

/// Every texel at one distance, and face 3 (against y) empty.
CubeMap even_map(int n, float distance) {
    CubeMap map{n, {}};
    for (Face& face : map.faces) face = whole_face(n, distance);
    map.faces[3] = {};
    return map;
}

Finding lit_seen(const Steps& steps, const Sample& sample) {
    const Receivers& seen = sample.seen;
    return same_shares_seen(shares(steps.lit, sample.map, seen.points, seen.biases), seen.lit,
                            sample);
}

struct Case {
    Vec3 from_light;
    float bias, share;
};

Finding cases_hold(Filter filter, const CubeMap& map, std::span<const Case> cases,
                   std::string_view of) {
    std::vector<Receiver> receivers;
    std::vector<float> biases, expected;
    for (const Case& each : cases) {
        receivers.push_back({each.from_light, {0, 1, 0}});
        biases.push_back(each.bias);
        expected.push_back(each.share);
    }
    return same_shares(shares(filter, map, receivers, biases), expected, of);
}

/// All stored at 2. The distance is that along the ray, and just as far as stored is lit.
Finding just_as_far(const Steps& steps, const Sample& sample) {
    const std::vector<Case> cases{{{2, 0, 0}, 0, 1},          {{2.5f, 0, 0}, 0.5f, 1},
                                  {{0, 2.5f, 0}, 0.25f, 0},   {{0, 0, -2.125f}, 0.125f, 1},
                                  {{1, 2, 2}, 0.5f, 0},       {{1, 2, -2}, 1, 1},
                                  {{1.9f, 1.9f, 1.9f}, 1, 0}, {{-0.5f, 0, 0}, 0, 1},
                                  {{-2.25f, 0, 0}, 0.25f, 1}};
    return cases_hold(steps.lit, even_map(sample.map.n, 2), cases, "receiver");
}

/// In the light; where nothing is stored; edge on.
std::vector<Case> ends() {
    return {{Vec3(0), 0, 1},
            {{0, -50, 3}, 0, 1},
            {{30, 1, 2}, infinite, 1},
            {{30, 1, 2}, 0.5f, 0},
            {{2, -1e20f, 0}, 0, 1}};
}

Finding lit_at_the_ends(const Steps& steps, const Sample& sample) {
    CubeMap open = even_map(sample.map.n, 1);
    open.faces[4] = whole_face(open.n, infinite);
    // Of face 5 only the half where x > 0 is stored.
    open.faces[5] = {{open.n / 2 + 1, 0, open.n, open.n},
                     Image<float>({open.n - open.n / 2 - 1, open.n}, 1)};
    std::vector<Case> cases = ends();
    cases.push_back({{0, 0.5f, 1e20f}, 0, 1});
    cases.push_back({{-3, 1, -8}, 0, 1});
    cases.push_back({{3, 1, -8}, 0, 0});
    return cases_hold(steps.lit, open, cases, "odd receiver");
}

Finding pcf_seen(const Steps& steps, const Sample& sample) {
    const Receivers& seen = sample.seen;
    std::vector<float> biases = seen.biases;
    for (float& bias : biases) bias *= pcf_width;
    return same_shares_seen(shares(steps.pcf, sample.map, seen.points, biases), seen.pcf, sample);
}

/// Some of the spots on a speckled map.
Finding speckles(const Steps& steps, const Sample& sample, std::size_t first, std::size_t count) {
    const std::span<const Receiver> spots = std::span(sample.spots).subspan(first, count);
    const std::vector<float> biases(count, spot_bias);
    return same_shares(shares(steps.pcf, speckled_map(sample.map.n), spots, biases),
                       std::span(sample.spot_shares).subspan(first, count), "spot");
}

Finding inside_faces(const Steps& steps, const Sample& sample) {
    return speckles(steps, sample, 0, spots_inside);
}

Finding across_edges(const Steps& steps, const Sample& sample) {
    return speckles(steps, sample, spots_inside, spots_on_rims);
}

Finding in_corners(const Steps& steps, const Sample& sample) {
    return speckles(steps, sample, spots_inside + spots_on_rims, spots_in_corners);
}

/// A map without a border in it has no half shadows; and the ends of lit.
Finding all_or_nothing(const Steps& steps, const Sample& sample) {
    CubeMap even = even_map(sample.map.n, 2);
    even.faces[3] = even.faces[0];
    const std::size_t count = sample.spots.size();
    const std::vector<float> none(count, 0), one(count, 1), all(count, 1.5f);
    std::vector<Receiver> far = sample.spots;
    for (Receiver& each : far) each.from_light *= 1.5f;
    return grading::first_failure_of(
        {same_shares(shares(steps.pcf, even, far, all), one, "lit spot"),
         same_shares(shares(steps.pcf, even, far, none), none, "dark spot"),
         cases_hold(steps.pcf, even_map(sample.map.n, 1), ends(), "odd receiver")});
}

}  // namespace

grading::Task lit_task(const Samples& samples) {
    return {"shadow_map.t5",
            "lit: is it as far as what is stored?",
            {{"shadow_map.t5.shadows", 1.5, cases_of(samples, lit_seen)},
             {"shadow_map.t5.just_as_far", 1, cases_of(samples, just_as_far)},
             {"shadow_map.t5.at_the_ends", 0.5, cases_of(samples, lit_at_the_ends)}}};
}

grading::Task pcf_task(const Samples& samples) {
    return {"shadow_map.t6",
            "pcf: the mean of nine answers",
            {{"shadow_map.t6.shadows", 1, cases_of(samples, pcf_seen)},
             {"shadow_map.t6.inside_faces", 1, cases_of(samples, inside_faces)},
             {"shadow_map.t6.across_edges", 2, cases_of(samples, across_edges)},
             {"shadow_map.t6.in_corners", 0.5, cases_of(samples, in_corners)},
             {"shadow_map.t6.all_or_nothing", 0.5, cases_of(samples, all_or_nothing)}}};
}

}  // namespace luch::homework::shadow_map
