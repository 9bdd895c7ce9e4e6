#include "scenes/generator/png.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace luch::assets {
namespace {

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
    return bytes;
}

/// The CRC of PNG (ISO 15948, annex D), bit by bit.
std::uint32_t crc(std::string_view bytes) {
    std::uint32_t sum = 0xffffffff;
    for (const char c : bytes) {
        sum ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) sum = sum & 1 ? sum >> 1 ^ 0xedb88320 : sum >> 1;
    }
    return ~sum;
}

std::string chunk(const std::string& type, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data +
           big_endian(crc(type + data));
}

/// The zlib format (RFC 1950) with stored blocks (RFC 1951, section 3.2.4).
std::string stored(std::string_view data) {
    std::uint32_t a = 1, b = 0;  // Adler-32
    for (const char c : data) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    std::string bytes = "\x78\x01";
    while (!data.empty()) {
        const std::size_t count = std::min<std::size_t>(data.size(), 65535);
        const auto low = [](std::size_t value) {
            return std::string{static_cast<char>(value & 0xff),
                               static_cast<char>(value >> 8 & 0xff)};
        };
        bytes += count == data.size() ? '\1' : '\0';
        bytes += low(count) + low(~count);
        bytes += data.substr(0, count);
        data.remove_prefix(count);
    }
    return bytes + big_endian(b << 16 | a);
}

}  // namespace

std::string png_bytes(const IndexedImage& image) {
    const auto [width, height] = image.size;
    std::string palette;
    for (const Byte3& c : image.palette) {
        palette +=
            {static_cast<char>(c.red), static_cast<char>(c.green), static_cast<char>(c.blue)};
    }
    std::string rows;
    for (int y = 0; y < height; ++y) {
        rows += '\0';  // no filter
        const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(y) * width;
        rows.append(row, row + width);
    }
    // 8 bits a pixel, colours from a palette.
    const std::string header = big_endian(static_cast<std::uint32_t>(width)) +
                               big_endian(static_cast<std::uint32_t>(height)) +
                               std::string("\x08\x03\0\0\0", 5);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("PLTE", palette) +
           chunk("IDAT", stored(rows)) + chunk("IEND", "");
}

}  // namespace luch::assets
