#pragma once

#include <string_view>

namespace luch::formats {

/// False when a Huffman table of a JPEG file promises more than 256 codes. stb_image 2.27 believes
/// the counts and writes past its tables.
bool jpeg_tables_fit(std::string_view bytes);

}  // namespace luch::formats
