#pragma once

#include "framework/math/vec.h"

#include <optional>
#include <vector>

namespace luch {

/// The keys that fly the camera; true while they are held, or when they went down and up again
/// since the last look.
struct FlyKeys {
    bool forward = false, back = false;
    bool left = false, right = false;
    bool up = false, down = false;
    bool fast = false;
    bool operator==(const FlyKeys&) const = default;
};

/// What a key press asks for, once each time it goes down.
enum class Command {
    quit,
    next_technique,
    previous_technique,
    compare,
    next_plane,
    marks,
    faster,
    slower,
    home,
    info,
    help,
    screenshot,
    time,
};

/// All that happened since the last look at the window.
struct Input {
    std::vector<Command> commands;
    FlyKeys keys;
    Vec2d drag_px{0};               ///< how far the mouse went with a button held; y downwards
    std::optional<double> mouse_x;  ///< where it is now, when it moved with no button held
    bool exposed = false;           ///< the window lost its contents or changed its size
};

}  // namespace luch
