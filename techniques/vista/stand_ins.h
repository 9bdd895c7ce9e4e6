#pragma once

#include "framework/image/image.h"
#include "framework/scene/scene.h"

#include <vector>

namespace luch::techniques::vista {

/// Hulls: closed convex polyhedra, each *around* a node that is no mesh. A ray that meets the node
/// has entered its hull before, so the front of the hull is a bound from below on the distance of
/// the hit. They are larger than they must be by more than what rounding to float may do to a ray,
/// a corner, or a distance (2⁻¹⁶ of their size and 2⁻¹⁹ of their distance).
struct Hulls {
    /// One node for each hull, its backs culled; only `geometry` and `to_object` of it are set.
    Scene scene;
    std::vector<NodeId> node_of;         ///< by node of `scene`: whose hull that is
    std::vector<std::uint8_t> segments;  ///< by node of `scene`: of a sphere's polyhedron; else 0
    std::vector<Tile> extents;           ///< by node of `scene`: no pixel beyond sees its hull
    /// Nodes that no hull can stand for: they have no end, or the eye is inside or too near.
    std::vector<NodeId> boundless;
};

/// The hulls as an eye needs them. Spheres get a polyhedron of `segments` meridians (even, at least
/// 4), or, if that is 0, of so many that it sticks out by less than a pixel; all other shapes get
/// their boxes. Meshes, and what is empty, get none. `wanted` false: all are boundless.
Hulls hulls_of(const Scene& scene, const Screen& screen, int segments, bool wanted = true);

/// By what the radius of a polyhedron of n meridians and n/2 bands in a sphere must grow so that it
/// is around it: 1 / [cos(π/n) · cos(π/(2·n/2))]. The middle of a face lies that much further in
/// than its corners.
double circumscribed(int n);

}  // namespace luch::techniques::vista
