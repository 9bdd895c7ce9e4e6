#pragma once

#include "framework/scene/loader/diagnostics.h"
#include "framework/scene/loader/mesh_builder.h"

namespace luch::loader {

/// Reads the polygons of a Wavefront OBJ file; materials, groups, lines and points are passed over.
/// A polygon is a fan from its first corner. Throws Error "file.obj:line: …" on a number that is
/// none or an index that leads nowhere.
RawMesh read_obj(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace luch::loader
