#pragma once

#include "framework/math/size.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace luch::assets {

/// A colour as a file stores it, sRGB.
struct Byte3 {
    std::uint8_t red, green, blue;
};

/// A colour ramp: stops at equal distances, straight lines between them, 256 steps.
std::array<Byte3, 256> ramp(std::span<const Byte3> stops);

/// A picture of up to 256 colours. (0, 0) is the top-left pixel.
struct IndexedImage {
    Size size;
    std::array<Byte3, 256> palette;
    std::vector<std::uint8_t> pixels;  ///< row-major indices into the palette
};

/// Paints value(x, y), clamped to 0..1, with a ramp of colours; x and y are the pixel's centre, in
/// 0..1 over the picture, y downwards.
IndexedImage painted(Size size, std::span<const Byte3> stops,
                     const std::function<double(double x, double y)>& value);

/// The bytes of an 8-bit BMP file, uncompressed; rows are stored from the bottom, each padded to
/// four bytes.
std::string bmp_bytes(const IndexedImage& image);

}  // namespace luch::assets
