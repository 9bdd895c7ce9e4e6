#pragma once

#include "framework/math/bounds.h"
#include "framework/scene/light.h"

#include <optional>
#include <span>
#include <vector>

namespace luch {

/// Chooses one of many lights for a surface point, each about as often as it matters there: a
/// binary tree over the lights, descended from the root by the power of a subtree over the square
/// of its distance, times the largest cosine with which it may shine on the surface (after Conty
/// Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018,
/// without their splitting). Of a single light its own shape is asked too: the side a rect light
/// shines to, a spot's cone. A light that cannot shine on the point is never chosen, one that can
/// always has a chance. Directional lights have no place and are not in it.
class LightTree {
 public:
    explicit LightTree(std::span<const Light> lights);

    struct Choice {
        std::uint32_t light;  ///< index into the lights
        double probability;
    };
    /// `random` in [0, 1). Nothing when no light shines to the normal's side of the point.
    [[nodiscard]] std::optional<Choice> choose(const Vec3d& point, const Vec3d& normal,
                                               double random) const;
    /// The probability of choose() to find that light.
    [[nodiscard]] double probability(std::uint32_t light, const Vec3d& point,
                                     const Vec3d& normal) const;
    [[nodiscard]] bool empty() const { return nodes_.empty(); }
    /// Whether there is one light only, and nothing to choose.
    [[nodiscard]] bool single() const { return nodes_.size() == 1; }

 private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    struct Node {
        Vec3d centre{0};
        double radius = 0;
        double power = 0;
        Vec3d axis{0};           ///< of a leaf that shines to one side or into a cone
        double axis_cosine = 0;  ///< the least cosine to the axis at which a point-like leaf shines
        std::uint32_t parent = none;
        std::uint32_t child = none;  ///< the first of two neighbours; none: a leaf
        std::uint32_t light = none;  ///< of a leaf
    };
    struct Leaf {
        Node node;
        Boxd box;
    };
    static std::optional<Leaf> leaf_of(const Light& light, std::uint32_t index);
    void build(std::uint32_t at, std::span<Leaf> leaves);
    static double importance(const Node& node, const Vec3d& point, const Vec3d& normal);

    std::vector<Node> nodes_;                   ///< the root first
    std::vector<std::uint32_t> leaf_of_light_;  ///< index into nodes_
};

}  // namespace luch
