#pragma once

#include "framework/math/bounds.h"
#include "framework/math/colour.h"
#include "techniques/sh_ambient/harmonics.h"

#include <array>
#include <cstdint>
#include <vector>

namespace luch::techniques::sh_ambient {

/// Light from all around a point, as far as nine coefficients tell: radiance, of basis functions
/// harmonics(). Those above `degree` are 0, and nobody looks at them.
struct Sh9 {
    std::array<Rgb, sh_terms> l{};
    int degree = 2;

    bool operator==(const Sh9&) const = default;
};

/// How far a probe sees, by direction: on the octahedron, unfolded to a square (Z. Cigolle et al.,
/// "A Survey of Efficient Representations for Independent Unit Vectors", JCGT 2014).
struct DistanceMap {
    static constexpr int side = 16;
    struct Texel {
        float mean = 0, mean_square = 0;
        bool operator==(const Texel&) const = default;
    };
    std::array<Texel, side * side> texels{};

    /// The unit direction through the middle of a texel.
    [[nodiscard]] static Vec3d direction(int x, int y);
    /// Bilinear.
    [[nodiscard]] Texel towards(const Vec3d& unit) const;
    bool operator==(const DistanceMap&) const = default;
};
inline constexpr int distance_sharpness = 100;

/// What is done against light that leaks through walls: nothing; probes behind a point's surface
/// count less; and probes that see less far than to the point, too (Z. Majercik, J.-P. Guertin, D.
/// Nowrouzezahrai, M. McGuire, "Dynamic Diffuse Global Illumination with Ray-Traced Irradiance
/// Fields", JCGT 8 (2), 2019).
enum class Leaks { shown, normals, distances };

/// A point of a surface that asks its probes.
struct Receiver {
    Vec3d position;
    Vec3d normal;  ///< of the true surface, unit length, on the lit side
};

/// Eight probes and how much each counts.
struct Blend {
    std::array<std::uint32_t, 8> probe{};
    std::array<float, 8> weight{};
};

/// count.x × count.y × count.z probes in a box.
struct ProbeGrid {
    Boxd box;
    glm::ivec3 count{0};
    std::vector<Sh9> light;              ///< x runs first, then y
    std::vector<DistanceMap> distances;  ///< as many, or none

    /// By how much of a cell a point is moved along its normal before it is asked whether a probe
    /// sees it.
    static constexpr double off_surface = 0.25;

    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
               static_cast<std::size_t>(count.z);
    }
    /// How far the outermost probes are from the box's sides, in its size/count.
    static constexpr double inset = 0.25;
    /// From a probe to the next along each axis.
    [[nodiscard]] Vec3d spacing() const {
        return box.size() * (1.0 - 2 * inset / Vec3d(count)) / Vec3d(glm::max(count - 1, 1));
    }
    [[nodiscard]] Vec3d first() const {
        return box.centre() - spacing() * (Vec3d(count - 1) / 2.0);
    }
    [[nodiscard]] Vec3d place(std::size_t probe) const;
    [[nodiscard]] std::uint32_t index(const glm::ivec3& at) const {
        return static_cast<std::uint32_t>((at.z * count.y + at.y) * count.x + at.x);
    }
    /// Memory that the probes hold.
    [[nodiscard]] std::uint64_t bytes() const {
        return light.size() * sizeof(Sh9) + distances.size() * sizeof(DistanceMap);
    }
};

}  // namespace luch::techniques::sh_ambient
