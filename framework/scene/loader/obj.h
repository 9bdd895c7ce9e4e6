#pragma once

#include "framework/scene/geometry.h"
#include "framework/scene/loader/diagnostics.h"

#include <filesystem>

namespace luch::loader {

struct ObjOptions {
    bool faceted = false;  ///< the triangles' own normals, whatever the file has
    bool auto_smooth =
        false;              ///< where the file has no normals: made from the faces around a vertex
    bool recenter = false;  ///< the mean of all vertices becomes the origin
};

/// Reads the polygons of a Wavefront OBJ file; materials, groups, lines and points are passed over.
/// A polygon is a fan from its first corner. A corner without a normal takes its triangle's, one
/// without texture coordinates (0, 0); without any normal (and autoSmooth) the mesh is faceted.
/// Throws Error "file.obj:line: …" on a number that is none or an index that leads nowhere.
Mesh read_obj(const std::filesystem::path& file, const ObjOptions& options,
              Diagnostics& diagnostics);

}  // namespace luch::loader
