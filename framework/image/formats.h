#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

#include <cstdint>
#include <filesystem>
#include <string_view>

/// The two libraries behind io.h, each in one source file. Only io.cpp includes this header.
namespace luch::formats {

/// What a file's header promises, before any pixel is read.
struct Header {
    Size size;
    int channels = 0;
};

/// The plug-in that a file's ending names: "png", "jpeg", "bmp" and "tga" are stb's, "openexr",
/// "hdr" and "tiff" are OpenImageIO's.
struct Format {
    const char* name;
    bool floating;  ///< OpenImageIO reads and writes it, in linear light
};

/// Throws Error{file} when the header is not of that format, or promises a side over the limit or
/// more pixels than a file of that many bytes can hold.
void check_header(const std::filesystem::path& file, const Header& header,
                  std::uintmax_t file_bytes);

/// The format that a file's first bytes tell: "png", "jpeg", "bmp", else "tga", which has no mark.
const char* stb_format_inside(std::string_view bytes);

/// Headers and pixels are read under check_header(). `bytes` is the whole file; `file` stands in
/// messages.
Header stb_header(const std::filesystem::path& file, std::string_view bytes, const Format& format);
Image<Rgb> stb_pixels(const std::filesystem::path& file, std::string_view bytes,
                      const Format& format);
/// `displayed` is sRGB in 0..1.
void stb_write(const std::filesystem::path& file, const Format& format,
               ImageView<const Rgb> displayed);

Header oiio_header(const std::filesystem::path& file, const Format& format);
Image<Rgb> oiio_pixels(const std::filesystem::path& file, const Format& format);
void oiio_write(const std::filesystem::path& file, const Format& format,
                ImageView<const Rgb> linear);

}  // namespace luch::formats
