#include "framework/window/window.h"

#include "framework/base/error.h"

#include <SDL2/SDL.h>

#include <cstdlib>
#include <string_view>

namespace luch {
namespace {

std::string_view variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string_view() : std::string_view(value);
}

bool shows_nothing(std::string_view driver) {
    return driver == "offscreen" || driver == "dummy";
}

/// Keys by where they lie, so that every keyboard layout flies alike.
bool* fly_key(FlyKeys& keys, SDL_Scancode code) {
    switch (code) {
        case SDL_SCANCODE_W:
        case SDL_SCANCODE_UP:
            return &keys.forward;
        case SDL_SCANCODE_S:
        case SDL_SCANCODE_DOWN:
            return &keys.back;
        case SDL_SCANCODE_A:
        case SDL_SCANCODE_LEFT:
            return &keys.left;
        case SDL_SCANCODE_D:
        case SDL_SCANCODE_RIGHT:
            return &keys.right;
        case SDL_SCANCODE_E:
        case SDL_SCANCODE_PAGEUP:
            return &keys.up;
        case SDL_SCANCODE_Q:
        case SDL_SCANCODE_PAGEDOWN:
            return &keys.down;
        case SDL_SCANCODE_LSHIFT:
        case SDL_SCANCODE_RSHIFT:
            return &keys.fast;
        default:
            return nullptr;
    }
}

std::optional<Command> command_of(const SDL_Keysym& key) {
    switch (key.scancode) {
        case SDL_SCANCODE_ESCAPE:
            return Command::quit;
        case SDL_SCANCODE_TAB:
            return (key.mod & KMOD_SHIFT) != 0 ? Command::previous_technique
                                               : Command::next_technique;
        case SDL_SCANCODE_C:
        case SDL_SCANCODE_SPACE:
            return Command::compare;
        case SDL_SCANCODE_P:
            return Command::next_plane;
        case SDL_SCANCODE_M:
            return Command::marks;
        case SDL_SCANCODE_EQUALS:
        case SDL_SCANCODE_KP_PLUS:
            return Command::faster;
        case SDL_SCANCODE_MINUS:
        case SDL_SCANCODE_KP_MINUS:
            return Command::slower;
        case SDL_SCANCODE_R:
        case SDL_SCANCODE_HOME:
            return Command::home;
        case SDL_SCANCODE_I:
            return Command::info;
        case SDL_SCANCODE_H:
        case SDL_SCANCODE_F1:
            return Command::help;
        case SDL_SCANCODE_F5:
            return Command::time;
        case SDL_SCANCODE_F12:
            return Command::screenshot;
        default:
            return std::nullopt;
    }
}

/// SDL's video part, for as long as the window lives.
class Video {
 public:
    explicit Video(bool offscreen) {
        if (offscreen) SDL_SetHint(SDL_HINT_VIDEODRIVER, "offscreen,dummy");
        SDL_SetMainReady();
        if (SDL_Init(SDL_INIT_VIDEO) != 0) fail();
        if (!offscreen && shows_nothing(SDL_GetCurrentVideoDriver())) {
            SDL_Quit();
            fail();
        }
    }
    ~Video() { SDL_Quit(); }
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

 private:
    [[noreturn]] static void fail() {
        const std::string reason = SDL_GetError();
        throw Error("the display cannot be opened (DISPLAY=" + std::string(variable("DISPLAY")) +
                    (reason.empty() ? "" : ": " + reason) +
                    "); check it, or unset DISPLAY and use --frames N or --screenshot FILE");
    }
};

class SdlWindow final : public Window {
 public:
    SdlWindow(const std::string& title, Size size, bool offscreen)
        : video_(offscreen),
          window_(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                   size.width, size.height, SDL_WINDOW_RESIZABLE),
                  SDL_DestroyWindow) {
        if (!window_) throw Error(std::string("no window can be opened: ") + SDL_GetError());
    }

    Input poll(int wait_ms) override {
        Input input;
        SDL_Event event;
        FlyKeys touched = held_;
        for (int more = SDL_WaitEventTimeout(&event, wait_ms); more != 0;
             more = SDL_PollEvent(&event)) {
            take(event, input, touched);
        }
        input.keys = touched;
        return input;
    }

    [[nodiscard]] Size size() const override {
        if ((SDL_GetWindowFlags(window_.get()) & (SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN)) != 0) {
            return {};
        }
        Size size;
        SDL_GetWindowSize(window_.get(), &size.width, &size.height);
        return size.width > 0 && size.height > 0 ? size : Size{};
    }

    void show(ImageView<const Pixel> picture) override {
        // Without a surface (the window was just resized or the screen lost) this picture is
        // dropped: an event follows, and with it the next one.
        SDL_Surface* screen = SDL_GetWindowSurface(window_.get());
        if (screen == nullptr || picture.size().area() == 0) return;
        const std::unique_ptr<SDL_Surface, decltype(&SDL_FreeSurface)> source(
            SDL_CreateRGBSurfaceWithFormatFrom(
                const_cast<Pixel*>(picture.data()), picture.width(), picture.height(), 32,
                picture.width() * static_cast<int>(sizeof(Pixel)), SDL_PIXELFORMAT_RGBA32),
            SDL_FreeSurface);
        if (!source) return;
        SDL_SetSurfaceBlendMode(source.get(), SDL_BLENDMODE_NONE);
        SDL_BlitSurface(source.get(), nullptr, screen, nullptr);
        SDL_UpdateWindowSurface(window_.get());
    }

 private:
    void take(const SDL_Event& event, Input& input, FlyKeys& touched) {
        switch (event.type) {
            case SDL_QUIT:
                input.commands.push_back(Command::quit);
                break;
            case SDL_KEYDOWN:
                take_key(event.key, input, touched);
                break;
            case SDL_KEYUP:
                if (bool* key = fly_key(held_, event.key.keysym.scancode)) *key = false;
                break;
            case SDL_MOUSEMOTION:
                take_motion(event.motion, input);
                break;
            case SDL_MOUSEWHEEL:
                if (event.wheel.y != 0) {
                    input.commands.push_back(event.wheel.y > 0 ? Command::faster : Command::slower);
                }
                break;
            case SDL_WINDOWEVENT:
                input.exposed = true;
                if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) held_ = {};
                break;
            case SDL_RENDER_TARGETS_RESET:
            case SDL_RENDER_DEVICE_RESET:
                input.exposed = true;
                break;
            default:
                break;
        }
    }

    void take_key(const SDL_KeyboardEvent& event, Input& input, FlyKeys& touched) {
        if (bool* key = fly_key(held_, event.keysym.scancode)) {
            *key = true;
            *fly_key(touched, event.keysym.scancode) = true;
        } else if (const auto command = command_of(event.keysym); command && event.repeat == 0) {
            input.commands.push_back(*command);
        }
    }

    static void take_motion(const SDL_MouseMotionEvent& event, Input& input) {
        if (event.state != 0) {
            input.drag_px += Vec2d(event.xrel, event.yrel);
        } else {
            input.mouse_x = event.x;
        }
    }

    Video video_;
    std::unique_ptr<SDL_Window, decltype(&SDL_DestroyWindow)> window_;
    FlyKeys held_;
};

}  // namespace

bool screen_present() {
    const std::string_view driver = variable("SDL_VIDEODRIVER");
    if (!driver.empty()) return !shows_nothing(driver);
    return !variable("DISPLAY").empty() || !variable("WAYLAND_DISPLAY").empty();
}

std::unique_ptr<Window> open_window(const std::string& title, Size size, bool offscreen) {
    return std::make_unique<SdlWindow>(title, size, offscreen);
}

}  // namespace luch
