#pragma once

#include "framework/scene/loader/assets.h"
#include "framework/scene/loader/gltf/part.h"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace luch::loader::gltf {

/// A glTF 2.0 file (.gltf, or .glb with its chunks) and the bytes that it names: beside it, below
/// the scene's root, or in data: URIs. The JSON is read by our own reader: libtinygltf 2.7
/// overflows its stack on nested extras, follows URIs out of the root and hands on accessors
/// unchecked.
class Document {
 public:
    /// Throws Error{file} on what is no glTF 2.0, or requires an extension that we do not read.
    Document(const std::filesystem::path& file, Assets& assets);

    [[nodiscard]] const Part& root() const { return root_; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] Assets& assets() { return *assets_; }

    /// An element of a top-level array, as `from` refers to it.
    [[nodiscard]] Part element(std::string_view array, std::uint64_t index, const Part& from) const;
    /// The bytes of a bufferView, wholly within its buffer.
    std::string_view view(std::uint64_t index, const Part& from);
    /// What a uri stands for, and the path it is called in messages.
    struct Bytes {
        std::filesystem::path name;
        std::string bytes;
    };
    Bytes read_uri(std::string_view uri, const Part& from) const;
    /// Bytes of the file and of all buffers read so far.
    [[nodiscard]] std::uint64_t bytes_read() const { return bytes_read_; }

 private:
    std::string_view buffer(std::uint64_t index, const Part& from);

    std::filesystem::path file_;
    Assets* assets_;
    std::string bytes_;
    std::string_view binary_;  ///< the second chunk of a .glb
    std::optional<JsonDocument> json_;
    Part root_;
    std::map<std::uint64_t, std::string> buffers_;  ///< those with a uri
    std::uint64_t bytes_read_ = 0;
};

}  // namespace luch::loader::gltf
