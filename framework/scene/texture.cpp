#include "framework/scene/texture.h"

#include "framework/scene/bilinear.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luch {
namespace {

template <class T>
T sampled(const Image<T>& image, double s, double t) {
    return bilinear<T>(image.size(), s, t, [&](int x, int y) { return image(x, y); });
}

Rgb colour_of(const CheckerTexture& checker, const TexturePoint& point) {
    const Vec2d& uv = point.uv;
    const double squares = std::floor(uv.x / checker.scaling) + std::floor(uv.y / checker.scaling);
    return std::fmod(squares, 2) == 0 ? checker.color1 : checker.color2;
}
Rgb colour_of(const BitmapTexture& bitmap, const TexturePoint& point) {
    const Vec2d size(bitmap.pixels.width(), bitmap.pixels.height());
    const Vec2d at = point.uv / bitmap.scaling - bitmap.texel_centre / size;
    return sampled(bitmap.pixels, at.x, at.y);
}
Rgb colour_of(const Fresnel& fresnel, const TexturePoint& point) {
    const double root = (1 - fresnel.ior) / (1 + fresnel.ior);
    const double straight = root * root;
    const double slant = 1 - std::min(1.0, std::abs(point.cosine));
    return Rgb(static_cast<float>(straight + (1 - straight) * std::pow(slant, 5)));
}
Rgb colour_of(const BumpTexture&, const TexturePoint&) {
    return Rgb(0);
}
Rgb colour_of(const Bumps&, const TexturePoint&) {
    return Rgb(0);
}

Vec2d tilt_of(const BumpTexture& bump, const Vec2d& uv) {
    return bump.strength * Vec2d(sampled(bump.slopes, uv.x * bump.scaling, uv.y * bump.scaling));
}
Vec2d tilt_of(const Bumps& bumps, const Vec2d& uv) {
    constexpr std::array amplitudes{0.1, 0.08, 0.05};
    constexpr std::array along_u{0.5, 1.21, 1.9}, along_v{0.4, 1.13, 1.81};
    Vec2d tilt(0);
    for (std::size_t i = 0; i < amplitudes.size(); ++i) {
        tilt.x += amplitudes[i] * std::sin(0.2 * along_u[i] * uv.x);
        tilt.y += amplitudes[i] * std::sin(0.2 * along_v[i] * uv.y);
    }
    return bumps.strength * tilt;
}
template <class Coloured>
Vec2d tilt_of(const Coloured&, const Vec2d&) {
    return Vec2d(0);
}

}  // namespace

bool is_bump(const Texture& texture) {
    return std::holds_alternative<BumpTexture>(texture) || std::holds_alternative<Bumps>(texture);
}

Rgb colour_at(const Texture& texture, const TexturePoint& point) {
    return std::visit([&](const auto& kind) { return colour_of(kind, point); }, texture);
}

Vec2d tilt_at(const Texture& texture, const Vec2d& uv) {
    return std::visit([&](const auto& kind) { return tilt_of(kind, uv); }, texture);
}

Image<Vec2> slopes_of(ImageView<const Rgb> heights) {
    const auto [width, height] = heights.size();
    const auto grey = [&](int x, int y) {
        const Rgb& pixel = heights(x, y);
        return (pixel.r + pixel.g + pixel.b) / 3;
    };
    Image<Vec2> slopes(heights.size());
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float here = grey(x, y);
            slopes(x, y) = {here - grey((x + 1) % width, y), here - grey(x, (y + 1) % height)};
        }
    }
    return slopes;
}

}  // namespace luch
