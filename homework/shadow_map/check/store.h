#pragma once

#include "framework/grading/stored.h"
#include "homework/shadow_map/check/samples.h"

// How a sample lies in files: one-channel EXR; lists are a row an element, the faces of a cube
// stand in two rows of three.
namespace luch::homework::shadow_map {

std::vector<grading::StoredPlane> planes_of(const Sample& sample);

/// Fills all but name, scene and the map's n from the files of a folder. Throws Error.
void read_planes(const std::filesystem::path& folder, Sample& sample);

/// Faces beside one another: 0, 1, 2 above 3, 4, 5.
Image<std::uint32_t> sheet_of(const std::array<Image<std::uint32_t>, faces_of_cube>& faces);
Image<float> sheet_of(const CubeMap& map);

}  // namespace luch::homework::shadow_map
