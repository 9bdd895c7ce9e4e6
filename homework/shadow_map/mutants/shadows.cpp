#include "homework/shadow_map/mutants/mutants.h"

#include <cmath>
#include <optional>

namespace luch::homework::shadow_map {
namespace {

using namespace techniques::shadow_map;

constexpr float infinite = std::numeric_limits<float>::infinity();

Texel texel_at(const Vec3& direction, int n) {
    Texel texel;
    reference().texel_of({&direction, 1}, n, {&texel, 1});
    return texel;
}

struct LitRules {
    bool reversed = false, no_bias = false, takes_bias_away = false, strict = false;
    bool depth = false, empty_is_dark = false, light_is_dark = false, next_texel = false;
    bool shares_only = false, by_normal = false;
};

template <LitRules rules>
float is_lit(const CubeMap& map, const Receiver& receiver, float bias) {
    const Vec3& p = receiver.from_light;
    Texel texel = texel_at(p, map.n);
    if (rules.next_texel) texel.x = std::min(texel.x + 1, map.n - 1);
    float stored = map.at(texel);
    if (rules.empty_is_dark && stored == infinite) stored = 0;
    const float distance = rules.depth ? max_norm(p) : glm::length(p);
    if (rules.light_is_dark && !(distance > 0)) return 0;
    if (rules.by_normal && glm::dot(receiver.normal, p) > 0) return 0;
    if (rules.no_bias) bias = 0;
    if (rules.takes_bias_away) bias = -bias;
    if (rules.shares_only) return distance <= stored + bias ? 1 : stored / distance;
    if (rules.strict) return distance < stored + bias ? 1 : 0;
    return (distance <= stored + bias) != rules.reversed ? 1 : 0;
}

template <LitRules rules>
void lit(const CubeMap& map, std::span<const Receiver> receivers, std::span<const float> biases,
         std::span<float> shares) {
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        shares[i] = is_lit<rules>(map, receivers[i], biases[i]);
    }
}

struct PcfRules {
    enum Edge { folded, kept_in, wrapped, left_out, dark, bright, same_place } edge = folded;
    enum Corner { none, dark_corner, kept_corner } corner = none;
    int from = -1, to = 1;
    bool averages_distances = false, by_nine = false, plus = false, tent = false;
    bool reversed = false, no_bias = false, strict = false, sum = false, depth = false;
    bool majority = false;
};

/// A texel's place, as far past an edge of its face as it goes.
template <PcfRules rules>
std::optional<Texel> neighbour(const Texel& t, int n) {
    const auto inside = [&](int at) { return std::clamp(at, 0, n - 1); };
    const bool past_x = t.x != inside(t.x), past_y = t.y != inside(t.y);
    if (past_x && past_y && rules.corner == PcfRules::none && rules.edge == PcfRules::folded) {
        return std::nullopt;
    }
    if (!past_x && !past_y) return t;
    if (rules.edge == PcfRules::kept_in || (past_x && past_y)) {
        return Texel{t.face, inside(t.x), inside(t.y)};
    }
    if (rules.edge == PcfRules::wrapped) return Texel{t.face, (t.x + n) % n, (t.y + n) % n};
    Vec3 d;
    d[t.face / 2] = t.face % 2 == 1 ? -1.0f : 1.0f;
    d[(t.face / 2 + 1) % 3] = float(2 * t.x + 1) / float(n) - 1;
    d[(t.face / 2 + 2) % 3] = float(2 * t.y + 1) / float(n) - 1;
    const Texel there = texel_at(d, n);
    if (rules.edge == PcfRules::same_place) return Texel{there.face, (t.x + n) % n, (t.y + n) % n};
    return there;
}

struct Sum {
    float of = 0, weights = 0;
    void add(float what, float weight) {
        of += weight * what;
        weights += weight;
    }
};

template <PcfRules rules>
float share_of(const CubeMap& map, const Receiver& receiver, float bias) {
    const Texel middle = texel_at(receiver.from_light, map.n);
    const float distance =
        rules.depth ? max_norm(receiver.from_light) : glm::length(receiver.from_light);
    const auto lit = [&](float stored) {
        const float most = stored + (rules.no_bias ? 0 : bias);
        if (rules.strict) return distance < most ? 1.0f : 0.0f;
        return (distance <= most) != rules.reversed ? 1.0f : 0.0f;
    };
    Sum sum;
    for (int dy = rules.from; dy <= rules.to; ++dy) {
        for (int dx = rules.from; dx <= rules.to; ++dx) {
            if (rules.plus && dx != 0 && dy != 0) continue;
            const float weight = rules.tent ? float((2 - std::abs(dx)) * (2 - std::abs(dy))) : 1;
            const Texel place{middle.face, middle.x + dx, middle.y + dy};
            const bool past = std::min(place.x, place.y) < 0 || std::max(place.x, place.y) >= map.n;
            const auto there = neighbour<rules>(place, map.n);
            if ((past && rules.edge == PcfRules::left_out) || !there) continue;
            if (past && (rules.edge == PcfRules::dark || rules.edge == PcfRules::bright)) {
                sum.add(rules.edge == PcfRules::bright ? 1.0f : 0.0f, weight);
                continue;
            }
            const bool corner = std::clamp(place.x, 0, map.n - 1) != place.x &&
                                std::clamp(place.y, 0, map.n - 1) != place.y;
            if (corner && rules.corner == PcfRules::dark_corner) {
                sum.add(0, weight);
            } else {
                const float stored = map.at(*there);
                sum.add(rules.averages_distances ? stored : lit(stored), weight);
            }
        }
    }
    const float mean = rules.sum ? sum.of : sum.of / (rules.by_nine ? 9 : sum.weights);
    if (rules.majority) return mean > 0.5f ? 1 : 0;
    return rules.averages_distances ? lit(mean) : mean;
}

template <PcfRules rules>
void pcf(const CubeMap& map, std::span<const Receiver> receivers, std::span<const float> biases,
         std::span<float> shares) {
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        shares[i] = share_of<rules>(map, receivers[i], biases[i]);
    }
}

template <LitRules rules>
grading::Other lit_mutant(const char* name, const char* cause) {
    return {name, "shadow_map.t5", cause, with(&Steps::lit, lit<rules>)};
}

template <PcfRules rules>
grading::Other pcf_mutant(const char* name, const char* cause) {
    return {name, "shadow_map.t6", cause, with(&Steps::pcf, pcf<rules>)};
}

}  // namespace

std::vector<grading::Other> shadow_mutants() {
    using P = PcfRules;
    return {
        lit_mutant<LitRules{.reversed = true}>("reversed", "the comparison is turned round"),
        lit_mutant<LitRules{.no_bias = true}>("bias_not_used", "the bias is not added: acne"),
        lit_mutant<LitRules{.takes_bias_away = true}>(
            "bias_taken_away", "the bias makes shadows of what is lit: it has the wrong sign"),
        lit_mutant<LitRules{.strict = true}>("strictly_less", "as far as stored is lit: ≤, not <"),
        lit_mutant<LitRules{.depth = true}>("depth_compared",
                                            "depth along the axis is compared with distances"),
        lit_mutant<LitRules{.empty_is_dark = true}>("empty_is_dark",
                                                    "where nothing is stored it is lit, not dark"),
        lit_mutant<LitRules{.light_is_dark = true}>("light_is_dark", "what is in the light is lit"),
        lit_mutant<LitRules{.next_texel = true}>("next_texel",
                                                 "the texel beside the receiver's is read"),
        lit_mutant<LitRules{.shares_only = true}>("fades",
                                                  "a ratio is returned: one comparison is 0 or 1"),
        lit_mutant<LitRules{.by_normal = true}>(
            "by_the_normal", "the normal may point either way: only distances are compared"),

        pcf_mutant<PcfRules{.averages_distances = true}>(
            "averages_distances",
            "distances are averaged, then compared: compare first, average the answers"),
        pcf_mutant<PcfRules{.edge = P::kept_in}>(
            "stays_on_its_face", "at the face's edge its own rim is read again: cross over"),
        pcf_mutant<PcfRules{.edge = P::wrapped}>(
            "wraps_round",
            "past the edge comes the same face's other side: cross "
            "over"),
        pcf_mutant<PcfRules{.edge = P::left_out}>("leaves_edges_out",
                                                  "texels past the edge are left out: cross over"),
        pcf_mutant<PcfRules{.edge = P::dark}>("dark_past_edges",
                                              "past the edge all is dark: cross over"),
        pcf_mutant<PcfRules{.edge = P::bright}>("bright_past_edges",
                                                "past the edge all is lit: cross over"),
        pcf_mutant<PcfRules{.edge = P::same_place}>(
            "not_turned_over",
            "the neighbouring face's axes are not those of this one: fold the "
            "place over the edge"),
        pcf_mutant<PcfRules{.corner = P::dark_corner}>(
            "dark_corner", "past a corner there is no texel: the mean is of eight"),
        pcf_mutant<PcfRules{.corner = P::kept_corner}>(
            "corner_twice",
            "the corner's texel is counted twice: the mean is "
            "of eight"),
        pcf_mutant<PcfRules{.from = 0, .to = 0}>("one_answer",
                                                 "only the receiver's own texel is read"),
        pcf_mutant<PcfRules{.from = -1, .to = 0}>("two_by_two",
                                                  "2 × 2 texels, half a texel off: 3 × 3"),
        pcf_mutant<PcfRules{.plus = true}>("plus_shaped",
                                           "the diagonal neighbours are missing: 3 × 3"),
        pcf_mutant<PcfRules{.tent = true}>("weighted",
                                           "the middle counts more: all nine count alike"),
        pcf_mutant<PcfRules{.reversed = true}>("pcf_reversed", "the comparison is turned round"),
        pcf_mutant<PcfRules{.no_bias = true}>("pcf_without_bias", "the bias is not added: acne"),
        pcf_mutant<PcfRules{.sum = true}>("not_a_mean", "the sum is not divided by the count"),
        pcf_mutant<PcfRules{.depth = true}>("pcf_of_depth",
                                            "depth along the axis is compared with distances"),
        pcf_mutant<PcfRules{.majority = true}>("majority", "the mean is rounded to 0 or 1"),
    };
}

}  // namespace luch::homework::shadow_map
