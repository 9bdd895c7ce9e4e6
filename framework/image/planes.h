#pragma once

#include "framework/image/image.h"

#include <cstdint>
#include <filesystem>

namespace luch {

/// One number a pixel, bit for bit: an OpenEXR file with the one channel "Y" as float or uint32
/// (ids). Both throw Error{file}: on a missing or damaged file, one of another kind, a full disk.
void write_plane(const std::filesystem::path& file, ImageView<const float> plane);
void write_plane(const std::filesystem::path& file, ImageView<const std::uint32_t> plane);
Image<float> read_float_plane(const std::filesystem::path& file);
Image<std::uint32_t> read_id_plane(const std::filesystem::path& file);

}  // namespace luch
