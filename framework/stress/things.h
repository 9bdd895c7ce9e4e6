#pragma once

#include "framework/scene/scene.h"

#include <array>
#include <string_view>

namespace luch::stress {

/// Shapes of about 1 in size around the origin. The ball is a mesh.
enum class Thing { sphere, cube, ball, solid, hills, square };
inline constexpr std::array<Thing, 6> all_things{Thing::sphere, Thing::cube,  Thing::ball,
                                                 Thing::solid,  Thing::hills, Thing::square};
/// Those with an inside; the origin is in it.
inline constexpr std::array<Thing, 4> closed_things{Thing::sphere, Thing::cube, Thing::ball,
                                                    Thing::solid};

/// "a sphere", "a solid"…
std::string_view to_string(Thing thing);

/// Adds it as a node.
void add(Scene& scene, Thing thing, const Material& material, const Transform& to_world = {});

/// One thing in a scene with a grey sky and no ambient light; the camera and a lamp stand before
/// it. All of it, lamp and camera too, is `scale` times as large and moved by `by`. 48 × 36 pixels.
Scene one_thing(Thing thing, double scale = 1, const Vec3d& by = Vec3d(0));

}  // namespace luch::stress
