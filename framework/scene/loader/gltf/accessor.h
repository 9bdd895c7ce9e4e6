#pragma once

#include "framework/math/vec.h"
#include "framework/scene/loader/gltf/document.h"

#include <vector>

namespace luch::loader::gltf {

/// Reads VEC2 or VEC3 (`type`), of any component type, normalised where the file says so, sparse
/// ones too. Every read is within its bufferView; every number is finite and at most 1e30.
std::vector<Vec3d> read_vectors(Document& document, std::uint64_t index, std::string_view type,
                                const Part& from);

/// Reads indices: unsigned SCALARs.
std::vector<std::uint32_t> read_indices(Document& document, std::uint64_t index, const Part& from);

}  // namespace luch::loader::gltf
