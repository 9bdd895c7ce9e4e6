#pragma once

#include "framework/scene/texture.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace luch {

/// A bitmap whose texels are words, 0xAARRGGBB in sRGB: a third of the bytes, and where it can be
/// made at all not a bit is lost.
class WordTexture {
 public:
    /// Nothing when some texel is no colour of 8 bits a channel in sRGB.
    static std::optional<WordTexture> of(const BitmapTexture& bitmap);

    /// Bit for bit the bitmap's colour_at().
    [[nodiscard]] Rgb colour_at(const Vec2d& uv) const;
    [[nodiscard]] std::size_t bytes() const { return texels_.pixels().size() * 4; }
    [[nodiscard]] const Image<std::uint32_t>& texels() const { return texels_; }

 private:
    Image<std::uint32_t> texels_;
    double scaling_ = 1, texel_centre_ = 0;
};

/// A scene's textures, by TextureId, where they are as good in words.
using WordTextures = std::vector<std::optional<WordTexture>>;
WordTextures word_textures(const std::vector<Texture>& textures);

}  // namespace luch
