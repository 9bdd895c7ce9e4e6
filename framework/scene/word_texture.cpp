#include "framework/scene/word_texture.h"

#include "framework/scene/bilinear.h"

#include <array>

namespace luch {
namespace {

/// srgb_decoded() of all levels, as picture files are read.
const std::array<float, 256>& decoded() {
    static const auto table = [] {
        std::array<float, 256> of_level{};
        float level = 0;
        for (float& linear : of_level) linear = srgb_decoded(level++ / 255);
        return of_level;
    }();
    return table;
}

std::optional<std::uint32_t> level_of(float linear) {
    const std::uint32_t level = byte_of(srgb_encoded(linear));
    if (decoded()[level] != linear) return {};
    return level;
}

std::optional<std::uint32_t> word_of(const Rgb& linear) {
    const auto r = level_of(linear.r), g = level_of(linear.g), b = level_of(linear.b);
    if (!r || !g || !b) return {};
    return 0xff000000u | *r << 16 | *g << 8 | *b;
}

Rgb colour_of(std::uint32_t word, const std::array<float, 256>& levels) {
    return {levels[word >> 16 & 255], levels[word >> 8 & 255], levels[word & 255]};
}

}  // namespace

std::optional<WordTexture> WordTexture::of(const BitmapTexture& bitmap) {
    WordTexture made;
    made.texels_ = Image<std::uint32_t>(bitmap.pixels.size());
    made.scaling_ = bitmap.scaling;
    made.texel_centre_ = bitmap.texel_centre;
    for (std::size_t i = 0; i < made.texels_.pixels().size(); ++i) {
        const auto word = word_of(bitmap.pixels.pixels()[i]);
        if (!word) return {};
        made.texels_.pixels()[i] = *word;
    }
    return made;
}

Rgb WordTexture::colour_at(const Vec2d& uv) const {
    const Vec2d size(texels_.width(), texels_.height());
    const Vec2d at = uv / scaling_ - texel_centre_ / size;
    const std::array<float, 256>& levels = decoded();
    return bilinear<Rgb>(texels_.size(), at.x, at.y,
                         [&](int x, int y) { return colour_of(texels_(x, y), levels); });
}

WordTextures word_textures(const std::vector<Texture>& textures) {
    WordTextures words;
    for (const Texture& texture : textures) {
        const auto* bitmap = std::get_if<BitmapTexture>(&texture);
        words.push_back(bitmap != nullptr ? WordTexture::of(*bitmap) : std::nullopt);
    }
    return words;
}

}  // namespace luch
