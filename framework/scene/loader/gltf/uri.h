#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace luch::loader::gltf {

/// The bytes of a data: URI in base64, or nothing when it is not one.
std::optional<std::string> data_of(std::string_view uri);

/// A relative URI as a file name: %20 and the like decoded. Nothing when it is malformed, has a
/// scheme, or holds a zero byte.
std::optional<std::string> file_name_of(std::string_view uri);

}  // namespace luch::loader::gltf
