#pragma once

#include "framework/grading/stored.h"
#include "homework/ssao/check/samples.h"

// How a sample lies in files: one-channel EXR of floats; x, y, z side by side.
namespace luch::homework::ssao {

std::vector<grading::StoredPlane> planes_of(const Sample& sample);

/// Fills all but name and scene from the files of a folder. Throws Error.
void read_planes(const std::filesystem::path& folder, Sample& sample);

}  // namespace luch::homework::ssao
