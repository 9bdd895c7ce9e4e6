#include "framework/image/io.h"

#include "framework/base/error.h"
#include "framework/base/files.h"
#include "framework/base/text.h"
#include "framework/image/formats.h"

#include <fmt/format.h>

namespace luch {
namespace {

using formats::Format;

constexpr int max_side = 16384;

struct Ending {
    std::string_view text;
    Format format;
    bool written;
};

constexpr Ending endings[] = {
    {".png", {"png", false}, true},   {".jpg", {"jpeg", false}, true},
    {".jpeg", {"jpeg", false}, true}, {".bmp", {"bmp", false}, true},
    {".tga", {"tga", false}, true},   {".exr", {"openexr", true}, true},
    {".hdr", {"hdr", true}, true},    {".tif", {"tiff", true}, false},
    {".tiff", {"tiff", true}, false},
};

Format format_of(const std::filesystem::path& file, bool to_write) {
    const std::string wanted = lower(file.extension().string());
    std::vector<std::string> known;
    for (const Ending& ending : endings) {
        if (to_write && !ending.written) continue;
        if (ending.text == wanted) return ending.format;
        known.emplace_back(ending.text);
    }
    throw Error({file.string()},
                fmt::format("the ending \"{}\" is not a picture's; use {}", wanted, listed(known)));
}

/// Opening a folder, a pipe or a device as a picture would fail late or never.
void check_is_file(const std::filesystem::path& file) {
    std::error_code problem;
    const auto status = std::filesystem::status(file, problem);
    if (!std::filesystem::exists(status)) {
        throw Error({file.string()}, "does not exist; check the name");
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw Error({file.string()}, "is not a file; name a picture");
    }
}

/// PNG or JPEG, by the first bytes.
Format format_inside(std::string_view bytes, const std::filesystem::path& name) {
    const Format format{formats::stb_format_inside(bytes), false};
    if (format.name == std::string_view("png") || format.name == std::string_view("jpeg")) {
        return format;
    }
    throw Error({name.string()}, "is neither PNG nor JPEG; save the picture as one of them");
}

template <class Curve>
Image<Rgb> mapped(Image<Rgb> image, const Curve& curve) {
    for (Rgb& pixel : image.pixels()) pixel = curve(pixel);
    return image;
}

}  // namespace

void formats::check_header(const std::filesystem::path& file, const Header& header,
                           std::uintmax_t file_bytes) {
    const auto [width, height] = header.size;
    if (width < 1 || height < 1 || width > max_side || height > max_side) {
        throw Error({file.string()}, fmt::format("is {} x {} pixels; make no side longer than {}",
                                                 width, height, max_side));
    }
    // No format here packs better than 1 : 1,032 (deflate) by more than a little, so a small file
    // that promises a huge picture is cut off or made to exhaust the memory.
    constexpr std::uintmax_t best_ratio = 4096;
    const std::uintmax_t bytes = header.size.area() * std::max(header.channels, 1);
    if (bytes / best_ratio > file_bytes) {
        throw Error({file.string()},
                    fmt::format("promises {} x {} pixels but holds only {} bytes; it is damaged",
                                width, height, file_bytes));
    }
}

Size picture_size(const std::filesystem::path& file) {
    const Format format = format_of(file, false);
    check_is_file(file);
    if (format.floating) return formats::oiio_header(file, format).size;
    return formats::stb_header(file, read_text(file), format).size;
}

Picture read_picture(const std::filesystem::path& file) {
    const Format format = format_of(file, false);
    check_is_file(file);
    if (format.floating) return {formats::oiio_pixels(file, format), Encoding::linear};
    return {formats::stb_pixels(file, read_text(file), format), Encoding::srgb};
}

Size picture_size(std::string_view bytes, const std::filesystem::path& name) {
    return formats::stb_header(name, bytes, format_inside(bytes, name)).size;
}

Picture read_picture(std::string_view bytes, const std::filesystem::path& name) {
    return {formats::stb_pixels(name, bytes, format_inside(bytes, name)), Encoding::srgb};
}

Image<Rgb> read_linear(const std::filesystem::path& file) {
    Picture picture = read_picture(file);
    if (picture.encoding == Encoding::linear) return std::move(picture.pixels);
    return mapped(std::move(picture.pixels), [](const Rgb& c) { return srgb_decoded(c); });
}

Image<Rgb> read_displayed(const std::filesystem::path& file) {
    Picture picture = read_picture(file);
    if (picture.encoding == Encoding::srgb) return std::move(picture.pixels);
    return mapped(std::move(picture.pixels), [](const Rgb& c) { return srgb_encoded(c); });
}

void write_picture(const std::filesystem::path& file, ImageView<const Rgb> linear) {
    const Format format = format_of(file, true);
    std::error_code ignored;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
    if (format.floating) return formats::oiio_write(file, format, linear);
    Image<Rgb> displayed(linear.size());
    for (std::size_t i = 0; i < linear.size().area(); ++i) {
        displayed.pixels()[i] = srgb_encoded(linear.data()[i]);
    }
    formats::stb_write(file, format, displayed.view());
}

}  // namespace luch
