#pragma once

#include "framework/math/bounds.h"
#include "framework/scene/light.h"

#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace luch {

/// Chooses one of many lights for a surface point, each about as often as it matters there: a
/// binary tree over the lights, descended from the root by the power of a subtree over the square
/// of its distance, times the largest cosine with which it may shine on the surface, times the
/// largest cosine to its own axes (after Conty Estevez and Kulla, "Importance Sampling of Many
/// Lights with Adaptive Tree Splitting", 2018, without their splitting). A light that cannot shine
/// on the point is never chosen, one that can always has a chance. Directional lights have no place
/// and are not in it.
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
    /// The directions that a subtree shines in: some light's axis is within `spread` radians of
    /// the axis, and light within `reach` of that.
    struct Cone {
        static constexpr double all = std::numbers::pi;
        Vec3d axis{0, 1, 0};
        double spread = all;
        double reach = 0;

        [[nodiscard]] bool everywhere() const { return !(spread + reach < all); }
        [[nodiscard]] Cone with(const Cone& other) const;
    };
    struct Node {
        Vec3d centre{0};
        double radius = 0;
        double power = 0;
        Cone cone;
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
