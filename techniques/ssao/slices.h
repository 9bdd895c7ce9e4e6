#pragma once

#include "techniques/ssao/ssao.h"

namespace luch::techniques::ssao {

/// Samples that a slice takes, half of them to either side: with fewer, one slice takes fewer; with
/// more, there are more slices.
inline constexpr int samples_a_slice = 18;

/// The share of the hemisphere, weighted with the cosine, that is closed by what the picture shows
/// within the radius: modes bitmask and gtao of `params`. As for Steps::occlusion: 0 where nothing
/// is seen or the radius spans less than a pixel; normals that face away; any tiling.
void slices(const GBuffer& seen, const Screen& screen, const Params& params, Key key, Tile tile,
            ImageView<float> occluded);

}  // namespace luch::techniques::ssao
