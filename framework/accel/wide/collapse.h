#pragma once

#include "framework/accel/bvh.h"
#include "framework/accel/wide/tree.h"
#include "framework/scene/geometry.h"

namespace luch::wide {

/// The eight-wide view of a binary tree over a mesh's triangles: of a node's descendants, those of
/// the largest area are opened until eight are left.
Tree collapsed(const Bvh<Box>& bvh, const Mesh& mesh);

}  // namespace luch::wide
