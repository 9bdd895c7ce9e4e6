#pragma once

#include "framework/technique/context.h"
#include "techniques/shadow_map/shadow_map.h"

#include <glm/vec4.hpp>

namespace luch::techniques::shadow_map {

/// E(z), E(z²), E(z³), E(z⁴) of depths z in a neighbourhood.
using Powers = glm::dvec4;

/// Blurred moments of the depths in a cube map, with the same windows. Depths are distances scaled
/// to −1 (in the light)..1 (the farthest surface; nothing counts as that).
struct Moments {
    float farthest = 1;
    std::array<Image<glm::vec4>, faces_of_cube> faces;

    [[nodiscard]] double depth(float distance) const {
        return 2.0 * std::min(distance / farthest, 1.0f) - 1;
    }
    [[nodiscard]] std::uint64_t bytes() const;
};

/// Texels that the blur reaches to each side.
inline constexpr int blur_reach = 2;

/// Makes the moments of a whole map.
Moments moments_of(const CubeMap& map, Context& context);

/// No more than this share of the neighbourhood is at depth z or behind it: Chebyshev's inequality
/// (Donnelly and Lauritzen, "Variance Shadow Maps", 2006). A variance that rounding made negative
/// is none.
double lit_by_variance(const Powers& moments, double z);

/// The same, sharper, of four moments (Peters and Klein, "Moment Shadow Mapping", 2015): the
/// Hamburger moment problem's solution with the least in front of z.
double lit_by_moments(const Powers& moments, double z);

/// Shares of light, by four moments or by the first two.
void shares_by_moments(const CubeMap& map, const Moments& moments, bool four,
                       std::span<const Receiver> receivers, std::span<const float> biases,
                       std::span<float> shares);

}  // namespace luch::techniques::shadow_map
