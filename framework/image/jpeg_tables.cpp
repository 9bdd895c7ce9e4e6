#include "framework/image/jpeg_tables.h"

#include <algorithm>
#include <cstddef>

namespace luch::formats {
namespace {

constexpr unsigned define_tables = 0xc4, start_of_scan = 0xda;

/// Past the end there are zeros, as for stb.
unsigned byte_at(std::string_view bytes, std::size_t at) {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
}

unsigned length_at(std::string_view bytes, std::size_t at) {
    return byte_at(bytes, at) << 8 | byte_at(bytes, at + 1);
}

/// The tables of the segment whose length stands at `at`: each a class byte, 16 counts, the codes.
bool segment_fits(std::string_view bytes, std::size_t at) {
    const std::size_t end = std::min(at + length_at(bytes, at), bytes.size());
    for (std::size_t table = at + 2; table < end;) {
        unsigned codes = 0;
        for (std::size_t i = 1; i <= 16; ++i) codes += byte_at(bytes, table + i);
        if (codes > 256) return false;
        table += 17 + codes;
    }
    return true;
}

}  // namespace

bool jpeg_tables_fit(std::string_view bytes) {
    bool in_scans = false;
    for (std::size_t at = 2; at + 1 < bytes.size();) {
        const unsigned marker = byte_at(bytes, at + 1);
        if (byte_at(bytes, at) != 0xff || marker == 0xff) {
            ++at;
            continue;
        }
        at += 2;
        if (marker == define_tables && !segment_fits(bytes, at)) return false;
        in_scans |= marker == start_of_scan;
        // Before the scans, what other segments hold (a thumbnail, say) is not searched; after that
        // every pair of bytes that could be taken for the marker is.
        if (!in_scans) at += length_at(bytes, at);
    }
    return true;
}

}  // namespace luch::formats
