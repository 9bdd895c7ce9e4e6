#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace luch {

/// A folder of files that are called by a key made of their content's origin. What is written is
/// there wholly or not at all; what has been damaged since is as if it were not there. Several
/// programs may use one folder at once.
class Store {
 public:
    /// Nothing is made on disk before the first put(). `most_bytes`: when the files hold more,
    /// those longest unused are removed.
    explicit Store(std::filesystem::path folder,
                   std::uintmax_t most_bytes = std::uintmax_t{1} << 30);

    /// The bytes put under that key. Nothing when there are none, or they do not match their
    /// checksum; then the file is removed.
    [[nodiscard]] std::optional<std::string> get(const std::string& key) const;
    /// Keeps bytes under a key of letters and digits. False when the folder cannot be written:
    /// whoever only wants to save time may go on.
    bool put(const std::string& key, std::string_view bytes) const;
    /// Removes all files of the store, and the folder when nothing else is in it.
    void clear() const;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
    [[nodiscard]] std::filesystem::path file_of(const std::string& key) const;
    void trim(const std::filesystem::path& newest) const;

    std::filesystem::path folder_;
    std::uintmax_t most_bytes_;
};

/// Where references are kept unless told otherwise: $XDG_CACHE_HOME/luch, else ~/.cache/luch (XDG
/// Base Directory Specification 0.8). Empty when neither is known.
std::filesystem::path default_cache_folder();

}  // namespace luch
