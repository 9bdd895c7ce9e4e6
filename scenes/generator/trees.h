#pragma once

#include "scenes/generator/model.h"

namespace luch::assets {

// What grows in a forest, and what it grows on: one joint and one mesh each, without normals, so
// that the flat triangles of leaves stay flat. Units: metres; the foot stands at the origin.

/// A fir of about 11 m: whorls of drooping branches with needles as triangles.
Model fir(std::uint64_t seed);

/// A broad-leaved tree of about 8 m: a trunk, boughs, and leaves of two triangles in clusters.
Model broadleaf(std::uint64_t seed);

/// A bush of about 1.5 m, of the same leaves.
Model bush(std::uint64_t seed);

/// A rock of about 1 m: a sphere of triangles with bumps; closed.
Model rock(std::uint64_t seed);

}  // namespace luch::assets
