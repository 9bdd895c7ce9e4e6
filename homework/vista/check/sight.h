#pragma once

#include "techniques/vista/vista.h"

#include <vector>

// A second way to see triangles, by which the checker judges steps that only make them.
namespace luch::homework::vista {

/// What the rays through the pixels' centres meet first among some triangles in view space.
struct Sight {
    Image<std::uint32_t> ids;     ///< node, no_node where nothing is met
    Image<float> depth;           ///< z, infinity where nothing is met
    Image<std::uint32_t> layers;  ///< how many triangles are met in all
};

/// The ray of a pixel is d = (sx, sy, 1). It meets a triangle with the homogeneous corners
/// (p_i, w_i) where λ_i ≥ 0 solves Σ λ_i p_i = d, at depth 1 / Σ λ_i w_i (Olano, Greer, "Triangle
/// Scan Conversion using 2D Homogeneous Coordinates", 1997). Nothing needs to be clipped, and
/// points at infinity are as good as others.
Sight sight_of(std::span<const techniques::vista::Tri> triangles, const Screen& screen);

}  // namespace luch::homework::vista
