#pragma once

#include "framework/accel/isa.h"
#include "framework/accel/wide/tree.h"
#include "framework/scene/geometry.h"

#include <span>

namespace luch::wide {

/// The tree over a mesh's triangles: a binary one by the binned surface area heuristic, seen as
/// eight wide. The same for any number of threads and any `isa`. Below a depth it splits by count,
/// so no path is longer than max_depth whatever the mesh.
Tree built(const Mesh& mesh, Isa isa);

/// The same over boxes, none of them empty, each a leaf of its own: leaf_bit with its number.
Tree built(std::span<const Box> boxes, Isa isa);

}  // namespace luch::wide
