#include "framework/base/error.h"
#include "framework/base/files.h"
#include "framework/image/formats.h"
#include "framework/image/jpeg_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <string>

// Left out are the readers that hang or that nobody needs: HDR loops for ever on a truncated file.
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_NO_GIF
#define STBI_NO_PSD
#define STBI_NO_PIC
#define STBI_NO_PNM
#define STBI_NO_STDIO
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace luch::formats {
namespace {

/// A file in memory that notices when the decoder asks for more than there is: stb's own readers
/// take zeros for the missing bytes of a truncated BMP, TGA or JPEG and say nothing.
struct Source {
    std::string_view bytes;
    std::size_t at = 0;
    bool overrun = false;

    static int read(void* self, char* into, int wanted) {
        auto& source = *static_cast<Source*>(self);
        const std::size_t left = source.bytes.size() - source.at;
        const std::size_t count = std::min<std::size_t>(left, wanted);
        std::memcpy(into, source.bytes.data() + source.at, count);
        source.at += count;
        // stb fills its buffer of 128 bytes ahead of need; only such a call may come back short.
        constexpr int buffer = 128;
        if (count == 0 || (wanted != buffer && count < static_cast<std::size_t>(wanted))) {
            source.overrun = true;
        }
        return static_cast<int>(count);
    }
    static void skip(void* self, int by) {
        auto& source = *static_cast<Source*>(self);
        const auto target = static_cast<std::ptrdiff_t>(source.at) + by;
        const auto end = static_cast<std::ptrdiff_t>(source.bytes.size());
        source.overrun |= target < 0 || target > end;
        source.at = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(target, 0, end));
    }
    static int at_end(void* self) {
        const auto& source = *static_cast<Source*>(self);
        return source.at >= source.bytes.size();
    }
};

constexpr stbi_io_callbacks callbacks{Source::read, Source::skip, Source::at_end};

Source opened(const std::filesystem::path& file, std::string_view bytes, const Format& format) {
    if (bytes.empty()) throw Error({file.string()}, "is empty; save the picture again");
    const std::string_view inside = stb_format_inside(bytes);
    if (inside != format.name) {
        const std::string found = inside == "tga" ? "" : fmt::format(" but {}", inside);
        throw Error({file.string()}, fmt::format("is not {}{}; save it as what its ending says",
                                                 format.name, found));
    }
    if (inside == "jpeg" && !jpeg_tables_fit(bytes)) {
        throw Error({file.string()}, "is damaged (bad Huffman table); save it again");
    }
    return {bytes};
}

/// A PNG's width or height, big-endian in its header at byte 16 or 20.
int png_side(std::string_view bytes, std::size_t at) {
    std::uint32_t side = 0;
    for (std::size_t i = at; i < std::min(at + 4, bytes.size()); ++i) {
        side = side << 8 | static_cast<unsigned char>(bytes[i]);
    }
    return static_cast<int>(std::min<std::uint32_t>(side, std::numeric_limits<int>::max()));
}

Header header_of(const std::filesystem::path& file, const Format& format, Source& source) {
    Header header;
    if (format.name == std::string_view("png")) {
        // Beyond 2³⁰ bytes stb says no more than "unknown image type".
        header = {{png_side(source.bytes, 16), png_side(source.bytes, 20)}, 1};
        check_header(file, header, source.bytes.size());
    }
    const int known = stbi_info_from_callbacks(&callbacks, &source, &header.size.width,
                                               &header.size.height, &header.channels);
    if (!known) {
        throw Error({file.string()}, fmt::format("cannot be read as {} ({}); save it again as "
                                                 "8 bits a channel",
                                                 format.name, stbi_failure_reason()));
    }
    check_header(file, header, source.bytes.size());
    source.at = 0;
    source.overrun = false;
    return header;
}

void append(void* text, void* data, int size) {
    static_cast<std::string*>(text)->append(static_cast<const char*>(data),
                                            static_cast<std::size_t>(size));
}

}  // namespace

const char* stb_format_inside(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "png";
    if (bytes.starts_with("\xff\xd8\xff")) return "jpeg";
    if (bytes.starts_with("BM")) return "bmp";
    return "tga";
}

Header stb_header(const std::filesystem::path& file, std::string_view bytes, const Format& format) {
    Source source = opened(file, bytes, format);
    return header_of(file, format, source);
}

Image<Rgb> stb_pixels(const std::filesystem::path& file, std::string_view bytes,
                      const Format& format) {
    Source source = opened(file, bytes, format);
    const Header header = header_of(file, format, source);
    Size size;
    int channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> decoded(
        stbi_load_from_callbacks(&callbacks, &source, &size.width, &size.height, &channels, 3),
        stbi_image_free);
    if (source.overrun) throw Error({file.string()}, "ends too early; save or copy it again");
    if (!decoded || size != header.size) {
        const char* reason = decoded ? "two sizes" : stbi_failure_reason();
        throw Error({file.string()}, fmt::format("is damaged ({}); save it again", reason));
    }
    Image<Rgb> image(size);
    const stbi_uc* byte = decoded.get();
    for (Rgb& pixel : image.pixels()) {
        pixel = Rgb(byte[0], byte[1], byte[2]) / 255.0f;
        byte += 3;
    }
    return image;
}

void stb_write(const std::filesystem::path& file, const Format& format,
               ImageView<const Rgb> displayed) {
    const auto [width, height] = displayed.size();
    std::vector<std::uint8_t> bytes;
    bytes.reserve(displayed.size().area() * 3);
    for (std::size_t i = 0; i < displayed.size().area(); ++i) {
        for (int k = 0; k < 3; ++k) bytes.push_back(byte_of(displayed.data()[i][k]));
    }
    std::string text;
    const std::string_view name = format.name;
    int fine = 0;
    if (name == "png") {
        fine = stbi_write_png_to_func(append, &text, width, height, 3, bytes.data(), width * 3);
    } else if (name == "bmp") {
        fine = stbi_write_bmp_to_func(append, &text, width, height, 3, bytes.data());
    } else if (name == "tga") {
        fine = stbi_write_tga_to_func(append, &text, width, height, 3, bytes.data());
    } else {
        constexpr int quality = 95;
        fine = stbi_write_jpg_to_func(append, &text, width, height, 3, bytes.data(), quality);
    }
    if (!fine) throw Error({file.string()}, "cannot be packed; is the picture empty?");
    write_text(file, text);
}

}  // namespace luch::formats
