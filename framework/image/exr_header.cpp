#include "framework/image/exr_header.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <string>

namespace luch::formats {
namespace {

/// Little-endian; 0 past the end.
std::uint32_t number(std::istream& stream) {
    std::array<char, 4> bytes{};
    stream.read(bytes.data(), bytes.size());
    std::uint32_t value = 0;
    for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return stream ? value : 0;
}

/// A name ends at a zero byte; a file's longest is 255.
std::string name(std::istream& stream) {
    std::string text;
    for (char c = 0; text.size() < 256 && stream.get(c) && c != 0;) text += c;
    return text;
}

}  // namespace

bool exr_attributes_fit(const std::filesystem::path& file) {
    constexpr std::uint32_t magic = 20000630, many_parts = 1 << 12;
    std::error_code ignored;
    const std::uintmax_t size = std::filesystem::file_size(file, ignored);
    std::ifstream stream(file, std::ios::binary);
    if (number(stream) != magic) return true;
    const bool has_parts = (number(stream) & many_parts) != 0;
    // Each attribute is a name, a type, a size and so many bytes; an empty name ends a header, and
    // an empty header ends those of a file of many parts.
    bool header_is_empty = true;
    while (stream) {
        if (name(stream).empty()) {
            if (!has_parts || header_is_empty) return true;
            header_is_empty = true;
            continue;
        }
        header_is_empty = false;
        name(stream);
        const std::uint32_t bytes = number(stream);
        if (bytes > size) return false;
        stream.seekg(bytes, std::ios::cur);
    }
    return true;
}

}  // namespace luch::formats
