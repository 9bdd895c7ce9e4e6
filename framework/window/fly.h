#pragma once

#include "framework/scene/scene.h"
#include "framework/window/input.h"

namespace luch {

/// The camera after flying `distance` in world units the way that the keys say: forward and
/// sideways as it looks, up and down along the world's y. No key, or opposite ones: the same
/// camera, bit for bit. `fast` is for the caller to put into the distance.
Camera flown(const Camera& camera, const FlyKeys& keys, double distance);

/// The camera after the mouse was dragged: to the right turns right, downwards looks down. The
/// pitch stays within ±90°, the yaw within ±180°. `degrees_per_px` > 0.
Camera turned(const Camera& camera, const Vec2d& drag_px, double degrees_per_px);

/// Turning by this makes a drag across the whole frame cover its field of view from left to right;
/// where there is none (orthographic), a right angle.
double degrees_per_px(const Camera& camera, int width_px);

/// A speed that suits a scene, in world units a second: a quarter of the typical distance from the
/// camera to the middle of a node, or of a node's size where that is larger. Positive and finite.
double flying_speed(const Scene& scene);

/// How much `fast` multiplies it.
inline constexpr double fast_factor = 4;

}  // namespace luch
