#include "framework/measure/store.h"

#include "framework/base/error.h"
#include "framework/base/files.h"
#include "framework/measure/digest.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace luch {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view ending = ".luch";
constexpr std::size_t checksum_length = 64;

struct Stored {
    fs::path file;
    std::uintmax_t bytes;
    fs::file_time_type used;
};

/// The store's files. One that another program takes away meanwhile is passed over.
std::vector<Stored> files_in(const fs::path& folder) {
    std::vector<Stored> files;
    std::error_code problem;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, problem)) {
        if (entry.path().extension() != ending) continue;
        std::error_code gone;
        const std::uintmax_t bytes = entry.file_size(gone);
        const fs::file_time_type used = entry.last_write_time(gone);
        if (!gone) files.push_back({entry.path(), bytes, used});
    }
    return files;
}

}  // namespace

Store::Store(fs::path folder, std::uintmax_t most_bytes)
    : folder_(std::move(folder)), most_bytes_(most_bytes) {}

fs::path Store::file_of(const std::string& key) const {
    return folder_ / (key + std::string(ending));
}

std::optional<std::string> Store::get(const std::string& key) const {
    const fs::path file = file_of(key);
    std::error_code problem;
    if (!fs::is_regular_file(file, problem)) return std::nullopt;
    try {
        std::string whole = read_text(file, most_bytes_);
        std::string bytes = whole.size() < checksum_length ? "" : whole.substr(checksum_length);
        if (whole.substr(0, checksum_length) == digest_of(bytes)) {
            fs::last_write_time(file, fs::file_time_type::clock::now(), problem);
            return bytes;
        }
    } catch (const Error&) {
        // Unreadable is as good as absent: what it held can be made again.
    }
    fs::remove(file, problem);
    return std::nullopt;
}

bool Store::put(const std::string& key, std::string_view bytes) const {
    const fs::path file = file_of(key);
    const fs::path unfinished = file.string() + "." + std::to_string(getpid());
    std::error_code problem;
    try {
        write_text(unfinished, digest_of(bytes) + std::string(bytes));
    } catch (const Error&) {
        fs::remove(unfinished, problem);
        return false;
    }
    fs::rename(unfinished, file, problem);
    if (problem) return false;
    trim(file);
    return true;
}

void Store::trim(const fs::path& newest) const {
    std::vector<Stored> files = files_in(folder_);
    std::uintmax_t held = 0;
    for (const Stored& stored : files) held += stored.bytes;
    std::sort(files.begin(), files.end(),
              [](const Stored& a, const Stored& b) { return a.used < b.used; });
    for (const Stored& stored : files) {
        if (held <= most_bytes_) return;
        if (stored.file == newest) continue;
        std::error_code problem;
        fs::remove(stored.file, problem);
        held -= stored.bytes;
    }
}

void Store::clear() const {
    std::error_code problem;
    for (const Stored& stored : files_in(folder_)) fs::remove(stored.file, problem);
    fs::remove(folder_, problem);  // only an empty folder can be removed
}

fs::path default_cache_folder() {
    const auto variable = [](const char* name) -> std::string {
        const char* value = std::getenv(name);
        return value == nullptr ? "" : value;
    };
    const fs::path cache = variable("XDG_CACHE_HOME");
    if (cache.is_absolute()) return cache / "luch";
    const fs::path home = variable("HOME");
    return home.is_absolute() ? home / ".cache" / "luch" : fs::path();
}

}  // namespace luch
