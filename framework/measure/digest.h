#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace luch {

/// SHA-256 (NIST, FIPS 180-4, 2015) of bytes that come in pieces: a name made of the content.
class Digest {
 public:
    /// Bytes as they are.
    void add(std::string_view bytes);
    /// A part that cannot run into its neighbours: its length goes first.
    Digest& part(std::string_view bytes);
    /// 64 hexadecimal digits of all that was added.
    [[nodiscard]] std::string text() const;

 private:
    void block(const unsigned char* bytes);
    void finish();

    std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<unsigned char, 64> waiting_{};
    std::uint64_t length_ = 0;  ///< bytes added
};

/// The digest of one text.
std::string digest_of(std::string_view bytes);

/// Of the bytes of files, in this order, whatever they are called. One that is not there counts as
/// such. Throws Error when one cannot be read.
std::string digest_of_files(std::span<const std::filesystem::path> files);

}  // namespace luch
