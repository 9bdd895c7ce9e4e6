#include "framework/scene/loader/gltf/chunks.h"

#include "framework/base/error.h"
#include "framework/base/text.h"

#include <fmt/format.h>

#include <cstdint>

namespace luch::loader::gltf {
namespace {

constexpr std::string_view magic = "glTF";
constexpr std::uint32_t json_type = 0x4e4f534a, binary_type = 0x004e4942;

/// Little-endian; the caller has checked that it is there.
std::uint32_t number(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

}  // namespace

Chunks chunks_of(std::string_view bytes, const std::filesystem::path& file) {
    constexpr std::size_t header = 12, chunk_header = 8;
    const auto fail = [&](const std::string& what) { throw Error({file.string()}, what); };
    if (!bytes.starts_with(magic)) {
        if (lower(file.extension().string()) == ".glb") {
            fail("does not begin with \"glTF\"; name a binary glTF file");
        }
        return {bytes, {}};
    }
    if (bytes.size() < header) fail("ends too early; copy it again");
    if (const auto version = number(bytes, 4); version != 2) {
        fail(fmt::format("is version {} of binary glTF; export it as version 2", version));
    }
    const std::size_t promised = number(bytes, 8);
    if (promised > bytes.size()) {
        fail(fmt::format("ends too early: it promises {} bytes and has {}; copy it again", promised,
                         bytes.size()));
    }
    bytes = bytes.substr(0, promised);
    Chunks chunks;
    for (std::size_t at = header; at < bytes.size();) {
        const bool whole = bytes.size() - at >= chunk_header &&
                           number(bytes, at) <= bytes.size() - at - chunk_header;
        if (!whole) fail(fmt::format("its chunk at byte {} ends too early; copy it again", at));
        const std::uint32_t type = number(bytes, at + 4);
        const std::string_view data = bytes.substr(at + chunk_header, number(bytes, at));
        if (at == header && type != json_type) fail("does not begin with JSON; export it again");
        if (at == header) chunks.json = data;
        if (type == binary_type && chunks.binary.empty()) chunks.binary = data;
        at += chunk_header + data.size();
    }
    return chunks;
}

}  // namespace luch::loader::gltf
