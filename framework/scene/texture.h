#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

#include <cstdint>
#include <variant>

namespace luch {

/// Index into Scene::textures; `no_texture` means none.
using TextureId = std::uint32_t;
inline constexpr TextureId no_texture = ~TextureId{0};

/// Squares of two colours: where floor(u/scaling) + floor(v/scaling) is even, color1.
struct CheckerTexture {
    Rgb color1{1};
    Rgb color2{0};
    double scaling = 20;
};

/// A picture in linear light, repeated every `scaling` units of u and v; v = 0 is the top row.
struct BitmapTexture {
    Image<Rgb> pixels;
    double scaling = 100;
    /// Where in its pixel a texel's colour is exact: at its corner in the course's format, in the
    /// middle (½) in glTF.
    double texel_centre = 0;
};

/// The slopes of a grey height picture: (a, b) at each pixel, see scene-format's BumpTexture.
struct BumpTexture {
    Image<Vec2> slopes;
    double strength = 1;
    double scaling = 1;
};

/// A bump of three fixed sine waves along u, and three along v.
struct Bumps {
    double strength = 1;
};

/// How much a clear surface reflects, by Schlick's formula ("An Inexpensive BRDF Model for
/// Physically-Based Rendering", 1994): grey, f + (1 − f)(1 − |cos|)⁵ with f = ((1 − ior)/(1 +
/// ior))².
struct Fresnel {
    double ior = 1.33;
};

using Texture = std::variant<CheckerTexture, BitmapTexture, BumpTexture, Bumps, Fresnel>;

/// Where a texture is looked up.
struct TexturePoint {
    Vec2d uv{0};
    double cosine = 1;  ///< between the surface's normal and the ray, in −1..1
};

/// Whether a texture tilts normals, and has no colour.
bool is_bump(const Texture& texture);

/// The texture's colour at a point. A bump has no colour: black.
Rgb colour_at(const Texture& texture, const TexturePoint& point);

/// How a bump tilts a normal at (u, v): strength·(a, b) along the surface's two tangents.
/// Zero for textures that are no bump.
Vec2d tilt_at(const Texture& texture, const Vec2d& uv);

/// The slopes of a height picture: a = I(x,y) − I(x+1,y), b = I(x,y) − I(x,y+1), indices wrap, I
/// grey.
Image<Vec2> slopes_of(ImageView<const Rgb> heights);

}  // namespace luch
