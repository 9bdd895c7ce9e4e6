#pragma once

#include "techniques/shadow_map/shadow_map.h"

namespace luch::techniques::shadow_map {

/// Shares of a light `width` wide whose middle the map looks from: the mean distance of what blocks
/// it tells the penumbra's width, and so how wide to filter (Fernando, "Percentage-Closer Soft
/// Shadows", 2005). `nearest`: the least distance in the map. `biases`: of one texel.
void soft_shares(const CubeMap& map, float nearest, double width,
                 std::span<const Receiver> receivers, std::span<const float> biases,
                 std::span<float> shares);

/// 1 or 0 where all of the 3 × 3 texels around agree, ShadowSource::unknown where they do not, or
/// where the bias is a large part of the distance. What is thinner than a texel may be missed.
/// `biases`: of pcf_width texels.
void agreed_shares(const CubeMap& map, std::span<const Receiver> receivers,
                   std::span<const float> biases, std::span<float> shares);

}  // namespace luch::techniques::shadow_map
