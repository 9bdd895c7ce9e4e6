#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

#include <filesystem>
#include <string_view>

namespace luch {

/// How the numbers of a picture file are meant.
enum class Encoding { linear, srgb };

/// A picture as its file holds it: 8-bit formats in 0..1 as stored (not decoded), float formats as
/// they are. Grey becomes three equal channels; alpha is dropped.
struct Picture {
    Image<Rgb> pixels;
    Encoding encoding = Encoding::linear;  ///< srgb for .png .bmp .jpg .jpeg .tga, else linear
};

/// Width and height by the file's header, under the same checks and errors as read_picture().
Size picture_size(const std::filesystem::path& file);

/// Reads a picture; the ending decides the format. The header is checked against the limits (a side
/// ≤ 16,384) before any pixel is read. Throws Error{file} when it is missing, truncated, too large
/// or not a picture.
Picture read_picture(const std::filesystem::path& file);

/// The same for a PNG or JPEG file in memory (the formats that glTF embeds), told apart by its
/// first bytes; `name` stands in messages.
Size picture_size(std::string_view bytes, const std::filesystem::path& name);
Picture read_picture(std::string_view bytes, const std::filesystem::path& name);

/// A picture file in linear light, whatever its encoding.
Image<Rgb> read_linear(const std::filesystem::path& file);

/// A picture file as displayed: sRGB, 0..1; linear files are encoded and clamped.
Image<Rgb> read_displayed(const std::filesystem::path& file);

/// Writes linear light. .exr (half float) and .hdr stay linear; .png, .bmp and .jpg get the sRGB
/// curve and 8 bits, rounded to nearest. Throws Error{file} on an unknown ending or a full disk.
void write_picture(const std::filesystem::path& file, ImageView<const Rgb> linear);

}  // namespace luch
