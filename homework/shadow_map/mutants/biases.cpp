#include "homework/shadow_map/mutants/mutants.h"

#include <cmath>

namespace luch::homework::shadow_map {
namespace {

using namespace techniques::shadow_map;

constexpr float infinite = std::numeric_limits<float>::infinity();

struct BiasRules {
    double factor = 1, constant = 0, share = 0;
    enum Sum { sizes, signs, larger, upward, root, only_u } sum = sizes;
    bool at_centre = false, of_depth = false, no_rounding = false, no_distance = false;
    bool by_tangent = false, edge_on_is_zero = false, unguarded = false, faces_light_only = false;
};

/// Along u and v of the face.
struct Slopes {
    double u = 0, v = 0;
};

template <BiasRules rules>
double together(const Slopes& slopes) {
    switch (rules.sum) {
        case BiasRules::sizes:
            return std::abs(slopes.u) + std::abs(slopes.v);
        case BiasRules::signs:
            return std::abs(slopes.u + slopes.v);
        case BiasRules::larger:
            return std::max(std::abs(slopes.u), std::abs(slopes.v));
        case BiasRules::upward:
            return std::max(slopes.u, 0.0) + std::max(slopes.v, 0.0);
        case BiasRules::root:
            return std::hypot(slopes.u, slopes.v);
        case BiasRules::only_u:
            return std::abs(slopes.u);
    }
    return 0;
}

template <BiasRules rules>
float bias_of(const Receiver& receiver, int n) {
    const Vec3d p(receiver.from_light), normal(receiver.normal);
    const double distance = glm::length(p);
    if (!(distance > 0)) return rules.unguarded ? std::nanf("") : 0;
    Texel texel;
    reference().texel_of({&receiver.from_light, 1}, n, {&texel, 1});
    const int axis = texel.face / 2, x = (axis + 1) % 3, y = (axis + 2) % 3;
    Vec3d q = p / std::abs(p[axis]);
    double away = distance;
    if (rules.at_centre) {
        Vec3 centre;
        reference().direction_of({&texel, 1}, n, {&centre, 1});
        q = Vec3d(centre) / std::abs(double(centre[axis]));
        away = std::abs(glm::dot(normal, p) / glm::dot(normal, q)) * glm::length(q);
    }
    const double along = glm::dot(normal, q), squared = glm::dot(q, q);
    if (along == 0) return rules.edge_on_is_zero ? 0 : infinite;
    if (rules.faces_light_only && along > 0) return 0;
    Slopes slopes{q[x] / squared - normal[x] / along, q[y] / squared - normal[y] / along};
    if (rules.of_depth) slopes = {normal[x] / along, normal[y] / along};
    double steepness = together<rules>(slopes);
    if (rules.by_tangent) {
        const double cosine = std::abs(along) / std::sqrt(squared);
        steepness = std::sqrt(std::max(0.0, 1 - cosine * cosine)) / cosine;
    }
    if (rules.no_distance) away = 1;
    const double rounding = rules.no_rounding ? 0 : rounding_share * distance;
    return static_cast<float>(rules.factor * away * steepness / n + rounding + rules.constant +
                              rules.share * distance);
}

template <BiasRules rules>
void bias(std::span<const Receiver> receivers, int n, std::span<float> biases) {
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        biases[i] = bias_of<rules>(receivers[i], n);
    }
}

template <BiasRules rules>
grading::Other mutant(const char* name, const char* cause) {
    return {name, "shadow_map.t4", cause, with(&Steps::bias, bias<rules>)};
}

}  // namespace

std::vector<grading::Other> bias_mutants() {
    return {
        mutant<BiasRules{.factor = 0, .no_rounding = true}>("no_bias",
                                                            "there is no bias: surfaces shade "
                                                            "themselves (acne)"),
        mutant<BiasRules{.factor = 0, .constant = 0.05}>(
            "constant_bias",
            "one number for all: too little for steep surfaces, too much for flat "
            "ones"),
        mutant<BiasRules{.factor = 0, .share = 0.02}>(
            "share_of_distance", "a share of the distance, whatever the slope"),
        mutant<BiasRules{.factor = 20}>("huge_bias", "far too large: shadows come off their feet"),
        mutant<BiasRules{.factor = 0.5}>(
            "half_the_bias", "half of it: h is 2/n, as a face is 2 wide, and ½h is 1/n"),
        mutant<BiasRules{.factor = 2}>("twice_the_bias",
                                       "twice as much: only half a texel, ½h, is needed"),
        mutant<BiasRules{.at_centre = true}>(
            "at_the_centre",
            "the gradient is that at the texel's centre: take the receiver's place"),
        mutant<BiasRules{.of_depth = true}>(
            "slope_of_depth", "the slope of the depth along the axis, not of the distance"),
        mutant<BiasRules{.sum = BiasRules::signs}>("signs_cancel",
                                                   "the two slopes may cancel: add their "
                                                   "sizes"),
        mutant<BiasRules{.sum = BiasRules::larger}>(
            "larger_slope",
            "only the larger slope: a texel's corner is off in "
            "both"),
        mutant<BiasRules{.sum = BiasRules::root}>(
            "length_of_gradient", "the gradient's length: a texel is square, add the sizes"),
        mutant<BiasRules{.sum = BiasRules::upward}>(
            "one_way_only",
            "slopes that fall do not count: the centre may be on "
            "either side"),
        mutant<BiasRules{.sum = BiasRules::only_u}>("only_along_x",
                                                    "only along x of the face: y is missing"),
        mutant<BiasRules{.by_tangent = true}>(
            "tangent", "the tangent of the angle: texels are smaller off the middle"),
        mutant<BiasRules{.no_distance = true}>("not_by_distance",
                                               "the slopes are not multiplied by the distance"),
        mutant<BiasRules{.no_rounding = true}>("no_rounding",
                                               "nothing is left for rounding: rounding_share"),
        mutant<BiasRules{.edge_on_is_zero = true}>("edge_on_is_zero",
                                                   "a plane through the light: infinite, not 0"),
        mutant<BiasRules{.unguarded = true}>("zero_over_zero",
                                             "0/0 where the receiver is in the light"),
        mutant<BiasRules{.faces_light_only = true}>(
            "one_side_only", "only normals towards the light: either side counts"),
    };
}

}  // namespace luch::homework::shadow_map
