#include "framework/base/files.h"

#include "framework/base/error.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace luch {

std::string read_text(const std::filesystem::path& file, std::uintmax_t limit) {
    std::error_code problem;
    const auto size = std::filesystem::file_size(file, problem);
    if (problem) {
        throw Error({file.string()}, "cannot be read (" + problem.message() + "); check the name");
    }
    if (size > limit) {
        throw Error({file.string()}, "is " + std::to_string(size) +
                                         " bytes, more than the limit of " + std::to_string(limit));
    }
    std::ifstream stream(file, std::ios::binary);
    std::string text(size, '\0');
    if (!stream.read(text.data(), static_cast<std::streamsize>(size))) {
        throw Error({file.string()}, "cannot be read; check its permissions");
    }
    return text;
}

void write_text(const std::filesystem::path& file, std::string_view text) {
    std::error_code ignored;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
    std::ofstream stream(file, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) {
        throw Error({file.string()}, std::string("cannot be written (") + std::strerror(errno) +
                                         "); choose a folder that exists and is yours");
    }
}

}  // namespace luch
