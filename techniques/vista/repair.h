#pragma once

#include "framework/trace/tracer.h"
#include "techniques/vista/vista.h"

namespace luch::techniques::vista {

/// How near anything else may be than the node that a pixel names: a bound from below on z in view
/// space of all triangles of other nodes, infinity where there are none.
void second_depths(std::span<const ScreenTri> triangles, Tile tile, ImageView<const NodeId> ids,
                   ImageView<float> second);

/// Traces the pixels of a tile whose hit is not certainly nearer than that, and sets fell_back.
void trace_doubtful(const Screen& screen, Tile tile, ImageView<const float> second, Tracer& tracer,
                    ImageView<Hit> hits, ImageView<std::uint8_t> fell_back);

}  // namespace luch::techniques::vista
