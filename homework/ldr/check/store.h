#pragma once

#include "framework/grading/stored.h"
#include "homework/ldr/check/samples.h"

// How a sample lies in files: one-channel EXR, floats or 32 bits, one plane below the other.
namespace luch::homework::ldr {

std::vector<grading::StoredPlane> planes_of(const Sample& sample);

/// The planes of a folder. Throws Error.
Sample read_sample(const std::filesystem::path& folder, const std::string& name);

}  // namespace luch::homework::ldr
