#pragma once

#include <filesystem>
#include <string_view>

namespace luch::loader::gltf {

/// The parts of a glTF file's bytes.
struct Chunks {
    std::string_view json;
    std::string_view binary;  ///< empty where there is none
};

/// A file that begins as a .glb is cut into its chunks (glTF 2.0 specification, section 4.4);
/// any other is JSON as a whole, unless its ending is .glb. Throws Error{file}.
Chunks chunks_of(std::string_view bytes, const std::filesystem::path& file);

}  // namespace luch::loader::gltf
