#include "framework/scene/loader/gltf/uri.h"

#include <charconv>
#include <cstdint>

namespace luch::loader::gltf {
namespace {

/// −1 for what is no letter of base64 (RFC 4648).
int six_bits(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

std::optional<std::string> decoded(std::string_view text) {
    for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int value = six_bits(c);
        if (value < 0) return std::nullopt;
        bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xffffff;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xff);
    }
    if (count == 6) return std::nullopt;  // a letter alone makes no byte
    return bytes;
}

}  // namespace

std::optional<std::string> data_of(std::string_view uri) {
    constexpr std::string_view scheme = "data:", coding = ";base64";
    const std::size_t comma = uri.find(',');
    if (!uri.starts_with(scheme) || comma == std::string_view::npos) return std::nullopt;
    if (!uri.substr(0, comma).ends_with(coding)) return std::nullopt;
    return decoded(uri.substr(comma + 1));
}

std::optional<std::string> file_name_of(std::string_view uri) {
    if (uri.empty() || uri.substr(0, uri.find('/')).find(':') != std::string_view::npos) {
        return std::nullopt;
    }
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            name += uri[i];
            continue;
        }
        int value = 0;
        const std::string_view digits = uri.substr(i + 1, 2);
        const char* const end = digits.data() + digits.size();
        const auto [stop, problem] = std::from_chars(digits.data(), end, value, 16);
        if (digits.size() != 2 || problem != std::errc{} || stop != end || value <= 0) {
            return std::nullopt;
        }
        name += static_cast<char>(value);
        i += 2;
    }
    if (name.find('\0') != std::string::npos) return std::nullopt;
    return name;
}

}  // namespace luch::loader::gltf
