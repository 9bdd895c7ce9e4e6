#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace luch {

/// The parts of ray tracing that a scene may not need. Leaving out what it does not need never
/// changes a bit of the picture.
enum class Part : std::uint8_t {
    texture_coordinates,  ///< where on a surface a point is
    bump,                 ///< tangents, and the normal tilted by a texture
    smooth_normals,       ///< normals interpolated between a mesh's corners
    transforms,           ///< between a node's own coordinates and the world's
    direct_light,         ///< the loop over the lights
    light_samples,        ///< random points of lights with an area
    shared_shadows,       ///< shadow rays of a tile to a light in one place, in packets
    dark_shadow_rays,     ///< shadow rays where the light adds nothing anyway
    mirrors,
    clear_things,
    layers,
    black_branches,  ///< mirrors, clear things and layers whose colour is black
    environment,     ///< a picture of the sky; else it is one colour
    visible_lights,
    solids,
    heightfields,
    scene_tree,  ///< the search for the nodes that a ray may meet
    lens,
    anti_aliasing,
    placed_lights,   ///< path tracing: lights that have a place
    distant_lights,  ///< path tracing: directional lights
    sky,             ///< path tracing: light from the sky
};

/// How plans and reports call it, and what is counted of it.
struct PartName {
    std::string_view name, counted;
};
inline constexpr std::array part_names{
    PartName{"texture coordinates", "points"},
    PartName{"bump", "points"},
    PartName{"smooth normals", "points"},
    PartName{"transforms", "points"},
    PartName{"direct light", "points"},
    PartName{"light samples", "samples"},
    PartName{"shared shadows", "tiles"},
    PartName{"dark shadow rays", "rays"},
    PartName{"mirrors", "points"},
    PartName{"clear things", "points"},
    PartName{"layers", "points"},
    PartName{"black branches", "branches"},
    PartName{"environment", "rays"},
    PartName{"visible lights", "points"},
    PartName{"solids", "points"},
    PartName{"heightfields", "points"},
    PartName{"scene tree", "searches"},
    PartName{"lens", "rays"},
    PartName{"anti-aliasing", "pixels"},
    PartName{"placed lights", "points"},
    PartName{"distant lights", "points"},
    PartName{"sky", "points"},
};
static_assert(part_names.size() == static_cast<std::size_t>(Part::sky) + 1);

[[nodiscard]] constexpr const PartName& name_of(Part part) {
    return part_names[static_cast<std::size_t>(part)];
}

/// What the hot code asks: a switch for each part.
class Needs {
 public:
    /// All of them, or none.
    constexpr explicit Needs(bool all = true) { needed_.fill(all); }

    [[nodiscard]] constexpr bool operator[](Part part) const {
        return needed_[static_cast<std::size_t>(part)];
    }
    [[nodiscard]] constexpr bool& operator[](Part part) {
        return needed_[static_cast<std::size_t>(part)];
    }
    /// The same but for one part.
    [[nodiscard]] constexpr Needs without(Part part) const {
        Needs needs = *this;
        needs[part] = false;
        return needs;
    }

 private:
    std::array<bool, part_names.size()> needed_{};
};

}  // namespace luch
