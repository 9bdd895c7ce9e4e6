#include "scenes/generator/indexed_image.h"

#include <algorithm>
#include <cmath>

namespace luch::assets {
namespace {

void put(std::string& bytes, std::uint32_t value, int count) {
    for (int k = 0; k < count; ++k) bytes += static_cast<char>(value >> (8 * k) & 0xff);
}

std::uint8_t between(int a, int b, int step, int steps) {
    return static_cast<std::uint8_t>((2 * (a * (steps - step) + b * step) + steps) / (2 * steps));
}

}  // namespace

std::array<Byte3, 256> ramp(std::span<const Byte3> stops) {
    std::array<Byte3, 256> colours;
    const int legs = static_cast<int>(stops.size()) - 1;
    for (int i = 0; i < 256; ++i) {
        const int leg = std::min(i * legs / 255, legs - 1);
        const Byte3 &a = stops[leg], &b = stops[leg + 1];
        const int step = i * legs - leg * 255;
        colours[i] = {between(a.red, b.red, step, 255), between(a.green, b.green, step, 255),
                      between(a.blue, b.blue, step, 255)};
    }
    return colours;
}

IndexedImage painted(Size size, std::span<const Byte3> stops,
                     const std::function<double(double x, double y)>& value) {
    IndexedImage image{size, ramp(stops), {}};
    image.pixels.reserve(size.area());
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double v = value((x + 0.5) / size.width, (y + 0.5) / size.height);
            image.pixels.push_back(
                static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0, 1.0) * 255)));
        }
    }
    return image;
}

std::string bmp_bytes(const IndexedImage& image) {
    constexpr std::uint32_t header = 14 + 40 + 256 * 4;
    const int padding = (4 - image.size.width % 4) % 4;
    const std::uint32_t data = (image.size.width + padding) * image.size.height;
    std::string bytes = "BM";
    put(bytes, header + data, 4);
    put(bytes, 0, 4);
    put(bytes, header, 4);
    put(bytes, 40, 4);
    put(bytes, image.size.width, 4);
    put(bytes, image.size.height, 4);
    put(bytes, 1, 2);  // planes
    put(bytes, 8, 2);  // bits a pixel
    put(bytes, 0, 4);  // no compression
    put(bytes, data, 4);
    put(bytes, 2835, 4);  // pixels a metre: 72 an inch
    put(bytes, 2835, 4);
    put(bytes, 256, 4);
    put(bytes, 0, 4);
    for (const Byte3& c : image.palette) {
        put(bytes, c.blue | c.green << 8 | c.red << 16, 4);
    }
    for (int y = image.size.height - 1; y >= 0; --y) {
        const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(y) * image.size.width;
        bytes.append(row, row + image.size.width);
        bytes.append(padding, '\0');
    }
    return bytes;
}

}  // namespace luch::assets
