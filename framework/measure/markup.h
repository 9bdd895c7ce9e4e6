#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace luch {

/// Text made safe for HTML and SVG, in elements and in quoted attributes.
std::string escaped(std::string_view text);

/// "data:image/png;base64,…" of a PNG file. Throws Error when it cannot be read.
std::string png_data_uri(const std::filesystem::path& file);

/// Base64 (RFC 4648), padded.
std::string base64(std::string_view bytes);

}  // namespace luch
