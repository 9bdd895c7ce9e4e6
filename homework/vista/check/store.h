#pragma once

#include "framework/grading/stored.h"
#include "homework/vista/check/samples.h"

// How a sample lies in files: one-channel EXR, floats or ids. A list of triangles has a row for
// each: x, y, z, w of three corners and the node; on the screen x, y, 1/z of three and the node.
namespace luch::homework::vista {

std::vector<grading::StoredPlane> planes_of(const Sample& sample);
std::vector<grading::StoredPlane> planes_of(const LodSample& sample);

/// Fills all but name and scene from the files of a folder. Throws Error.
void read_planes(const std::filesystem::path& folder, Sample& sample);
LodSample read_lod(const std::filesystem::path& folder);

}  // namespace luch::homework::vista
