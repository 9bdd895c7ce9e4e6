#pragma once

#include "framework/scene/scene.h"

namespace luch {

/// What a scene is made of, counted once. Plans are made from it. Only what nodes show counts, and
/// of materials only those that some node has, or a layer of one.
struct Census {
    std::size_t nodes = 0;
    std::size_t moved = 0;         ///< nodes that do not stand where their geometry says
    std::size_t bumps = 0;         ///< nodes with a bump
    std::size_t smooth = 0;        ///< nodes whose normals are interpolated
    std::size_t solids = 0;        ///< nodes of constructive solid geometry
    std::size_t heightfields = 0;  ///< nodes that are heightfields

    std::size_t lit = 0;       ///< materials that lights shine on: Lambert, Phong
    std::size_t textured = 0;  ///< materials with a texture
    std::size_t mirrors = 0;   ///< materials that reflect, in a colour that is not black
    std::size_t clear = 0;     ///< materials that refract, in a colour that is not black
    std::size_t layered = 0;   ///< materials made of layers
    std::size_t glowing = 0;   ///< materials of visible lights

    std::size_t standing_lights = 0;  ///< that shine from one point: point and spot lights
    std::size_t area_lights = 0;      ///< with an area: rect lights
    std::size_t distant_lights = 0;   ///< directional lights

    [[nodiscard]] std::size_t lights() const {
        return standing_lights + area_lights + distant_lights;
    }
};

Census census_of(const Scene& scene);

}  // namespace luch
