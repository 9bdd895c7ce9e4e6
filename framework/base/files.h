#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace luch {

/// The bytes of a file. Throws Error when it cannot be read or is larger than `limit` bytes.
std::string read_text(const std::filesystem::path& file, std::uintmax_t limit = 1u << 30);

/// Writes a file, creating its folder. Throws Error naming the file and the system's reason.
void write_text(const std::filesystem::path& file, std::string_view text);

}  // namespace luch
