#include "framework/base/error.h"
#include "framework/image/exr_header.h"
#include "framework/image/formats.h"
#include "framework/image/planes.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luch::formats {
namespace {

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;

/// The library's own words, on one line.
std::string reason(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text.empty() ? "no reason given" : text;
}

Header header_of(const ImageSpec& spec) {
    return {{spec.width, spec.height}, spec.nchannels};
}

/// Opened by the plug-in that the ending names, never by trying them all.
std::unique_ptr<ImageInput> opened(const std::filesystem::path& file, const Format& format,
                                   ImageSpec& spec) {
    if (!exr_attributes_fit(file)) {
        throw Error({file.string()},
                    "is damaged (an attribute is larger than the file); save it "
                    "again");
    }
    auto input = ImageInput::create(format.name);
    if (!input) {
        throw Error({file.string()}, fmt::format("OpenImageIO was built without {} ({})",
                                                 format.name, reason(OIIO::geterror())));
    }
    if (!input->open(file.string(), spec)) {
        throw Error({file.string()}, fmt::format("cannot be read as {} ({}); save it again",
                                                 format.name, reason(input->geterror())));
    }
    return input;
}

Header checked_header(const std::filesystem::path& file, const ImageSpec& spec) {
    std::error_code ignored;
    const Header header = header_of(spec);
    check_header(file, header, std::filesystem::file_size(file, ignored));
    return header;
}

void check_spec(const std::filesystem::path& file, const ImageSpec& spec) {
    checked_header(file, spec);
    constexpr std::uintmax_t most_bytes = std::uintmax_t{4} << 30;
    if (spec.deep || spec.depth > 1 || spec.nchannels < 1 || spec.image_bytes() > most_bytes) {
        throw Error({file.string()},
                    "is deep, a volume or has too many channels; save it as a flat RGB picture");
    }
}

/// Half floats end at 65,504; a brighter pixel is written as that rather than as infinity.
std::vector<float> within_half(ImageView<const Rgb> linear) {
    constexpr float largest = 65504;
    std::vector<float> values;
    values.reserve(linear.size().area() * 3);
    for (std::size_t i = 0; i < linear.size().area(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const float v = linear.data()[i][k];
            values.push_back(std::isfinite(v) ? std::clamp(v, -largest, largest) : v);
        }
    }
    return values;
}

constexpr Format exr{"openexr", true};

[[noreturn]] void cannot_be_written(const std::filesystem::path& file, const ImageOutput* output) {
    const std::string why = output != nullptr ? output->geterror() : OIIO::geterror();
    throw Error({file.string()},
                fmt::format("cannot be written ({}); choose a folder that exists and is yours",
                            reason(why)));
}

template <class T>
void write_one_channel(const std::filesystem::path& file, ImageView<const T> plane,
                       OIIO::TypeDesc type) {
    ImageSpec spec(plane.width(), plane.height(), 1, type);
    spec.attribute("compression", "zip");
    const auto output = ImageOutput::create(exr.name);
    bool fine = output && output->open(file.string(), spec);
    if (fine) {
        fine = output->write_image(type, plane.data());
        fine = output->close() && fine;
    }
    if (!fine) cannot_be_written(file, output.get());
}

template <class T>
Image<T> read_one_channel(const std::filesystem::path& file, OIIO::TypeDesc type) {
    ImageSpec spec;
    const auto input = opened(file, exr, spec);
    check_spec(file, spec);
    if (spec.nchannels != 1 || spec.format != type) {
        throw Error({file.string()}, fmt::format("is not one channel of {}", type.c_str()));
    }
    Image<T> plane({spec.width, spec.height});
    if (!input->read_image(0, 0, 0, 1, type, plane.pixels().data()) || input->has_error()) {
        throw Error({file.string()}, fmt::format("ends too early or is damaged ({})",
                                                 reason(input->geterror())));
    }
    return plane;
}

}  // namespace

Header oiio_header(const std::filesystem::path& file, const Format& format) {
    ImageSpec spec;
    opened(file, format, spec);
    return checked_header(file, spec);
}

Image<Rgb> oiio_pixels(const std::filesystem::path& file, const Format& format) {
    ImageSpec spec;
    const auto input = opened(file, format, spec);
    check_spec(file, spec);
    const int channels = spec.nchannels < 3 ? 1 : 3;
    Image<Rgb> image({spec.width, spec.height});
    std::vector<float> grey;
    if (channels == 1) grey.resize(image.size().area());
    void* into = channels == 1 ? static_cast<void*>(grey.data()) : image.pixels().data();
    const bool fine = input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, into);
    // A truncated TIFF reads as fine; only the message tells.
    if (!fine || input->has_error()) {
        throw Error({file.string()},
                    fmt::format("ends too early or is damaged ({}); save or copy it again",
                                reason(input->geterror())));
    }
    for (std::size_t i = 0; i < grey.size(); ++i) image.pixels()[i] = Rgb(grey[i]);
    return image;
}

void oiio_write(const std::filesystem::path& file, const Format& format,
                ImageView<const Rgb> linear) {
    const bool half = std::string_view(format.name) == "openexr";
    ImageSpec spec(linear.width(), linear.height(), 3,
                   half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
    if (half) spec.attribute("compression", "zip");
    const auto output = ImageOutput::create(format.name);
    bool fine = output && output->open(file.string(), spec);
    if (fine) {
        const std::vector<float> values = half ? within_half(linear) : std::vector<float>();
        const void* from = half ? static_cast<const void*>(values.data()) : linear.data();
        fine = output->write_image(OIIO::TypeDesc::FLOAT, from);
        fine = output->close() && fine;
    }
    if (!fine) cannot_be_written(file, output.get());
}

}  // namespace luch::formats

namespace luch {

void write_plane(const std::filesystem::path& file, ImageView<const float> plane) {
    formats::write_one_channel(file, plane, OIIO::TypeDesc::FLOAT);
}

void write_plane(const std::filesystem::path& file, ImageView<const std::uint32_t> plane) {
    formats::write_one_channel(file, plane, OIIO::TypeDesc::UINT32);
}

Image<float> read_float_plane(const std::filesystem::path& file) {
    return formats::read_one_channel<float>(file, OIIO::TypeDesc::FLOAT);
}

Image<std::uint32_t> read_id_plane(const std::filesystem::path& file) {
    return formats::read_one_channel<std::uint32_t>(file, OIIO::TypeDesc::UINT32);
}

}  // namespace luch
