#pragma once

#include "techniques/shadow_map/shadow_map.h"

namespace luch::techniques::shadow_map {

/// Shares of a light `width` wide whose middle the map looks from: the mean distance of what blocks
/// it tells the penumbra's width, and so how wide to filter (Fernando, "Percentage-Closer Soft
/// Shadows", 2005). Off the receiver's texel, its plane's distance there is compared. `biases`: of
/// one texel.
void soft_shares(const CubeMap& map, double width, std::span<const Receiver> receivers,
                 std::span<const float> biases, std::span<float> shares);

/// Of shares that pcf() found, keeps those of which all texels agree: 1 and 0. The others become
/// ShadowSource::unknown, and so do those whose bias is a large part of the distance. What is
/// thinner than a texel may have been missed.
void keep_agreed(std::span<const Receiver> receivers, std::span<const float> biases,
                 std::span<float> shares);

}  // namespace luch::techniques::shadow_map
