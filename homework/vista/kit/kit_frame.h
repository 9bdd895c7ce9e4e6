#pragma once

#include "homework/vista/check/samples.h"

// What the kit's plumbing needs to know of a frame.
namespace luch::techniques::vista {

/// The radius in pixels that a node appears with; infinite when the eye is inside its bounding
/// sphere or the node has no end.
float radius_px(const Scene& scene, const Node& node, const Screen& screen);

/// The stored answer for a radius in pixels, or for the next larger one.
int stored_segments(const homework::vista::LodSample& stored, float radius_px);

/// Drops the triangles that no ray from the eye can hit, where a mesh hides its backs.
void drop_backs(const Geometry& geometry, const Vec3d& eye_object, std::vector<Tri>& triangles);

/// Whether a triangle's image may reach into a tile. What is no number reaches everywhere.
bool touches(const ScreenTri& triangle, Tile tile);

/// Whether a shot is what a sample was stored of.
bool shows(const homework::vista::Sample& sample, const Scene& scene, const Shot& shot);

/// Stripes in the place of a picture that cannot be made yet, coloured by what the ids name.
void hatch(Tile tile, ImageView<const NodeId> ids, ImageView<Rgb> colour);

}  // namespace luch::techniques::vista
