#pragma once

#include "framework/trace/surface.h"

#include <limits>
#include <span>

// What a technique may know of light, so that the classic tracer need not look for it.
namespace luch {

/// How much of a light gets to a point, found without shadow rays: by a map, say. A share is of
/// what would arrive were nothing in between, 0..1.
class ShadowSource {
 public:
    virtual ~ShadowSource() = default;

    /// Not known: shadow rays shall tell, as if there were no source.
    static constexpr float unknown = -1;

    /// Of a light of the scene at some of a tile's points, `which` into `points`: a share for each.
    /// They are lit by Lambert's or Phong's law, and the light may reach their upper side.
    virtual void shares(std::size_t light, std::span<const Surface> points,
                        std::span<const std::uint32_t> which, std::span<float> shares) const = 0;

    /// At a point that is seen alone: in a mirror, through glass, in a layer.
    [[nodiscard]] virtual float share(std::size_t, const Surface&) const { return unknown; }
};

/// Ambient light that is not the same everywhere.
class AmbientSource {
 public:
    virtual ~AmbientSource() = default;

    /// The number of a point that no ray of the tile meets first.
    static constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

    /// What arrives at a surface, in the place of Settings::ambient_light: an albedo of 1 sends it
    /// on. `point`: the number of the tile's ray that meets it first, else nowhere.
    [[nodiscard]] virtual Rgb at(const Surface& surface, std::size_t point) const = 0;
};

/// What is given is asked; the rest is found as ever.
struct KnownLight {
    const ShadowSource* shadows = nullptr;
    const AmbientSource* ambient = nullptr;
};

}  // namespace luch
