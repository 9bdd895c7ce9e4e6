#include "framework/scene/loader/gltf/document.h"

#include "framework/base/error.h"
#include "framework/base/files.h"
#include "framework/scene/loader/gltf/chunks.h"
#include "framework/scene/loader/gltf/uri.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch::loader::gltf {
namespace {

constexpr std::string_view known_extensions[] = {"KHR_mesh_quantization"};

Part checked_root(JsonValue value, const std::string& file) {
    const Part root(value, file, "");
    if (!value.is_object()) root.fail("is no JSON object; name a glTF file");
    const auto version = root.required("asset").text("version").value_or("");
    if (!version.starts_with("2.")) {
        root.fail(fmt::format("is glTF {}; export it as glTF 2.0", shown(version)));
    }
    for (const std::string_view name : root.texts("extensionsRequired")) {
        if (std::find(std::begin(known_extensions), std::end(known_extensions), name) ==
            std::end(known_extensions)) {
            root.fail(
                fmt::format("needs the extension {}, which is not read here; export it "
                            "without",
                            shown(name)));
        }
    }
    return root;
}

void check_is_file(const std::filesystem::path& file, const Part& from) {
    if (!std::filesystem::is_regular_file(file)) {
        from.fail(fmt::format("{} does not exist; put it there", file.string()));
    }
}

}  // namespace

Document::Document(const std::filesystem::path& file, Assets& assets)
    : file_(file),
      assets_(&assets),
      bytes_(read_text(file)),
      root_([&] {
          const Chunks chunks = chunks_of(bytes_, file);
          binary_ = chunks.binary;
          json_.emplace(chunks.json, file.string());
          return checked_root(json_->root(), file.string());
      }()),
      bytes_read_(bytes_.size()) {}

Part Document::element(std::string_view array, std::uint64_t index, const Part& from) const {
    const std::size_t size = root_.size(array);
    if (index >= size) {
        from.fail(fmt::format("refers to {}[{}] of {}; correct the file", array, index, size));
    }
    return root_.element(array, index);
}

Document::Bytes Document::read_uri(std::string_view uri, const Part& from) const {
    if (uri.starts_with("data:")) {
        auto bytes = data_of(uri);
        if (!bytes) from.fail("its data: URI is no valid base64; export the model again");
        return {from.title(), *std::move(bytes)};
    }
    const auto name = file_name_of(uri);
    if (!name) from.fail(fmt::format("the uri {} names no file here; correct it", shown(uri)));
    std::filesystem::path path = assets_->beside(file_, *name);
    check_is_file(path, from);
    std::string bytes = read_text(path);
    return {std::move(path), std::move(bytes)};
}

std::string_view Document::buffer(std::uint64_t index, const Part& from) {
    const Part part = element("buffers", index, from);
    const auto uri = part.text("uri");
    if (!uri && (index > 0 || binary_.empty())) {
        part.fail("has no uri, and the file no binary chunk for it; export the model again");
    }
    if (uri && !buffers_.contains(index)) {
        const auto& bytes = buffers_[index] = read_uri(*uri, part).bytes;
        bytes_read_ += bytes.size();
    }
    const std::string_view bytes = uri ? std::string_view(buffers_[index]) : binary_;
    const std::uint64_t length = part.required_whole("byteLength");
    if (length > bytes.size()) {
        part.fail(fmt::format("should hold {} bytes and has {}; export the model again", length,
                              bytes.size()));
    }
    return bytes.substr(0, length);
}

std::string_view Document::view(std::uint64_t index, const Part& from) {
    const Part part = element("bufferViews", index, from);
    const std::uint64_t number = part.required_whole("buffer");
    const std::string_view bytes = buffer(number, part);
    const std::uint64_t offset = part.whole("byteOffset").value_or(0);
    const std::uint64_t length = part.required_whole("byteLength");
    if (offset + length > bytes.size()) {  // each at most 2^53
        part.fail(fmt::format("reaches to byte {} of the {} in buffers[{}]; correct the file",
                              offset + length, bytes.size(), number));
    }
    return bytes.substr(offset, length);
}

}  // namespace luch::loader::gltf
