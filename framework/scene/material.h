#pragma once

#include "framework/math/colour.h"
#include "framework/scene/texture.h"

#include <cstdint>
#include <variant>
#include <vector>

namespace luch {

/// Index into Scene::materials.
using MaterialId = std::uint32_t;
/// A node's material when its mesh has some of its own, one for each triangle: Mesh::materials.
/// Nobody but material_of() (scene.h) needs to know.
inline constexpr MaterialId materials_of_file = ~MaterialId{0};

/// Diffuse: colour, or a texture that replaces it.
struct Lambert {
    Rgb color{0.5f};
    TextureId texture = no_texture;
};

/// Lambert plus specular · light colour · max(0, cos γ)^exponent.
struct Phong {
    Rgb color{0.5f};
    TextureId texture = no_texture;
    Rgb specular{1};
    double exponent = 10;
};

/// A mirror; glossiness below 1 spreads the reflection over `samples` rays.
struct Reflection {
    Rgb multiplier{0.95f};
    double glossiness = 1;
    int samples = 50;
};

/// A clear surface that bends rays: Snell's law, black where the reflection is total. Inside, light
/// fades by Beer's law: exp(−absorption · d · (1 − inside_color)) over a length d.
struct Refraction {
    Rgb multiplier{0.95f};
    double ior = 1.33;  ///< of the inside, against the outside's 1
    Rgb inside_color{1};
    double absorption = 0;  ///< per world unit

    /// What is left of light after `distance` world units inside.
    [[nodiscard]] Rgb transmittance(double distance) const;
};

/// Materials over one another: c ← c·(1 − blend) + shader·blend, first layer first.
struct Layered {
    struct Layer {
        MaterialId material;
        Rgb blend;
        TextureId texture = no_texture;  ///< replaces `blend`
    };
    std::vector<Layer> layers;
};

/// The same colour from everywhere, unlit.
struct Const {
    Rgb color{0.5f};
};

/// The visible face of a RectLight: radiance on the side that it shines to (local −y), black
/// behind.
struct Emission {
    Rgb radiance{0};
};

using Material = std::variant<Lambert, Phong, Reflection, Refraction, Layered, Const, Emission>;

}  // namespace luch
