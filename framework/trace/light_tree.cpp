#include "framework/trace/light_tree.h"

#include <algorithm>

namespace luch {
namespace {

/// Angles are taken a little too large rather than too small: a chance of 0 must be certain.
constexpr double doubt = 1e-6;

double mean(const Rgb& colour) {
    return (static_cast<double>(colour.x) + colour.y + colour.z) / 3;
}

/// The largest cosine between an axis and a direction to any point of a ball, of which the middle
/// lies in `direction` and the radius is `sine` of its distance.
double largest_cosine(const Vec3d& axis, const Vec3d& direction, double sine) {
    const double cosine = glm::dot(axis, direction);
    const double ball = std::sqrt(std::max(0.0, 1 - sine * sine));
    if (cosine >= ball) return 1;
    const double other = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return std::min(1.0, cosine * ball + other * sine + doubt);
}

}  // namespace

LightTree::LightTree(std::span<const Light> lights) : leaf_of_light_(lights.size(), none) {
    std::vector<Leaf> leaves;
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
        if (auto leaf = leaf_of(lights[i], i)) leaves.push_back(std::move(*leaf));
    }
    if (leaves.empty()) return;
    nodes_.reserve(2 * leaves.size());
    nodes_.emplace_back();
    build(0, leaves);
}

std::optional<LightTree::Leaf> LightTree::leaf_of(const Light& light, std::uint32_t index) {
    Leaf leaf;
    leaf.node.light = index;
    if (const auto* point = std::get_if<PointLight>(&light)) {
        leaf.box.grow(point->position);
        leaf.node.power = std::abs(mean(point->color) * point->power);
    } else if (const auto* spot = std::get_if<SpotLight>(&light)) {
        leaf.box.grow(spot->position);
        leaf.node.power = std::abs(mean(spot->color) * spot->power);
        leaf.node.cone = {spot->direction, 0, std::acos(spot->outer_cosine) + doubt};
    } else if (const auto* rect = std::get_if<RectLight>(&light)) {
        for (const double x : {-0.5, 0.5}) {
            for (const double z : {-0.5, 0.5}) leaf.box.grow(rect->to_world.point({x, 0, z}));
        }
        leaf.node.power = std::abs(mean(rect->color) * rect->power);
        leaf.node.cone = {rect->facing(), 0, std::numbers::pi / 2 + doubt};
    } else {
        return std::nullopt;
    }
    if (!(leaf.node.power > 0)) return std::nullopt;
    leaf.node.centre = 0.5 * (leaf.box.lo + leaf.box.hi);
    leaf.node.radius = 0.5 * glm::length(leaf.box.hi - leaf.box.lo);
    return leaf;
}

void LightTree::build(std::uint32_t at, std::span<Leaf> leaves) {
    if (leaves.size() == 1) {
        const std::uint32_t parent = nodes_[at].parent;
        nodes_[at] = leaves[0].node;
        nodes_[at].parent = parent;
        leaf_of_light_[leaves[0].node.light] = at;
        return;
    }
    Boxd box, centres;
    for (const Leaf& leaf : leaves) {
        box.grow(leaf.box);
        centres.grow(leaf.node.centre);
        nodes_[at].power += leaf.node.power;
    }
    nodes_[at].centre = 0.5 * (box.lo + box.hi);
    nodes_[at].radius = 0.5 * glm::length(box.hi - box.lo);
    const Vec3d extent = centres.hi - centres.lo;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                     : extent.y >= extent.z                       ? 1
                                                                  : 2;
    const auto middle = leaves.begin() + static_cast<std::ptrdiff_t>(leaves.size() / 2);
    // Ties by the light's index: the tree does not depend on how a library partitions.
    std::nth_element(leaves.begin(), middle, leaves.end(), [&](const Leaf& a, const Leaf& b) {
        const double p = a.node.centre[axis], q = b.node.centre[axis];
        return p != q ? p < q : a.node.light < b.node.light;
    });
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_[at].child = child;
    nodes_.resize(nodes_.size() + 2);
    nodes_[child].parent = nodes_[child + 1].parent = at;
    build(child, leaves.first(leaves.size() / 2));
    build(child + 1, leaves.subspan(leaves.size() / 2));
    nodes_[at].cone = nodes_[child].cone.with(nodes_[child + 1].cone);
}

double LightTree::importance(const Node& node, const Vec3d& point, const Vec3d& normal) {
    const Vec3d way = node.centre - point;
    const double square = glm::dot(way, way), radius_square = node.radius * node.radius;
    const double reach = std::max(square, radius_square);
    if (!(reach > 0)) return 0;
    // Even a light of 10³⁰ at a hair's breadth must leave room for a sum of two.
    const double strength = std::min(node.power / reach, 1e300);
    if (square <= radius_square) return strength;
    const double distance = std::sqrt(square);
    const Vec3d direction = way / distance;
    const double sine = node.radius / distance;
    const double cosine = std::max(0.0, largest_cosine(normal, direction, sine));
    if (cosine == 0 || node.cone.everywhere()) return cosine * strength;
    const double away = std::acos(std::clamp(-glm::dot(node.cone.axis, direction), -1.0, 1.0));
    const double off = std::max(0.0, away - node.cone.spread - std::asin(sine) - doubt);
    // A spot's light does not fade with the cosine; no light is judged by less than a tenth.
    return off < node.cone.reach ? cosine * std::max(0.1, std::cos(off)) * strength : 0;
}

LightTree::Cone LightTree::Cone::with(const Cone& other) const {
    const Vec3d sum = axis + other.axis;
    Cone both;
    if (everywhere() || other.everywhere() || !(max_norm(sum) > 0)) return both;
    both.axis = glm::normalize(sum);
    const auto angle = [&](const Cone& cone) {
        return std::acos(std::clamp(glm::dot(both.axis, cone.axis), -1.0, 1.0)) + cone.spread;
    };
    both.spread = std::max(angle(*this), angle(other)) + doubt;
    both.reach = std::max(reach, other.reach);
    return both;
}

std::optional<LightTree::Choice> LightTree::choose(const Vec3d& point, const Vec3d& normal,
                                                   double random) const {
    if (nodes_.empty()) return std::nullopt;
    std::uint32_t at = 0;
    double probability = 1;
    if (nodes_[0].child == none && !(importance(nodes_[0], point, normal) > 0)) return std::nullopt;
    while (nodes_[at].child != none) {
        const std::uint32_t child = nodes_[at].child;
        const double first = importance(nodes_[child], point, normal);
        const double second = importance(nodes_[child + 1], point, normal);
        const double sum = first + second;
        if (!(sum > 0)) return std::nullopt;
        const double share = first / sum;
        const bool left = random < share || !(second > 0);
        random = left ? std::min(random / share, 1.0) : (random - share) / (1 - share);
        probability *= left ? share : second / sum;
        at = left ? child : child + 1;
    }
    return Choice{nodes_[at].light, probability};
}

double LightTree::probability(std::uint32_t light, const Vec3d& point, const Vec3d& normal) const {
    std::uint32_t at = leaf_of_light_[light];
    if (at == none) return 0;
    if (at == 0) return importance(nodes_[0], point, normal) > 0 ? 1 : 0;
    double probability = 1;
    while (at != 0) {
        const std::uint32_t child = nodes_[nodes_[at].parent].child;
        const double first = importance(nodes_[child], point, normal);
        const double second = importance(nodes_[child + 1], point, normal);
        const double sum = first + second;
        if (!(sum > 0)) return 0;
        probability *= (at == child ? first : second) / sum;
        at = nodes_[at].parent;
    }
    return probability;
}

}  // namespace luch
