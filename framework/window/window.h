#pragma once

#include "framework/image/image.h"
#include "framework/window/input.h"
#include "framework/window/pixel.h"

#include <memory>
#include <string>

namespace luch {

/// A window on the screen, or a make-believe one for tests.
class Window {
 public:
    virtual ~Window() = default;
    /// What happened since the last call; waits for something to happen, `wait_ms` at most.
    virtual Input poll(int wait_ms) = 0;
    /// Of its inside, in pixels; {0, 0} while nothing of it can be seen.
    [[nodiscard]] virtual Size size() const = 0;
    /// Shows a picture, top-left corner to top-left corner.
    virtual void show(ImageView<const Pixel> picture) = 0;
};

/// Whether there is a screen to open windows on: what DISPLAY, WAYLAND_DISPLAY and SDL_VIDEODRIVER
/// say. (SDL itself silently takes a driver that shows nothing when there is none.)
bool screen_present();

/// Opens a resizable window through SDL; `offscreen`, one that nobody sees, which works without a
/// screen. Throws Error when there is a screen, but it cannot be used.
std::unique_ptr<Window> open_window(const std::string& title, Size size, bool offscreen);

}  // namespace luch
