#pragma once

#include "framework/scene/scene.h"

// What a scene's light depends on, in 64 bits: kept work is good for as long as they stay the same.
namespace luch::techniques::sh_ambient {

/// Of the sky alone.
[[nodiscard]] std::uint64_t sky_fingerprint(const Scene& scene);

/// Of all that light meets: shapes, materials, lights, the sky, how deep mirrors show one another.
/// Not of cameras and names.
[[nodiscard]] std::uint64_t scene_fingerprint(const Scene& scene);

}  // namespace luch::techniques::sh_ambient
