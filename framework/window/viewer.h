#pragma once

#include "framework/window/compose.h"
#include "framework/window/fly.h"
#include "framework/window/refinement.h"
#include "framework/window/renderer.h"
#include "framework/window/window.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <utility>

namespace luch {

/// What the viewer can show: a technique of the catalogue, made.
struct ViewerEntry {
    std::string name;
    std::unique_ptr<Technique> technique;
};

/// What the viewer starts with.
struct ViewerSetup {
    std::vector<ViewerEntry> techniques;  ///< in Tab's order; at least one
    std::size_t shown = 0;                ///< index of the first to be shown
    std::size_t against = 0;              ///< of the one on the wiper's right; also the fallback
    bool compare = false;                 ///< begin with the wiper
    Shot shot;
    Budget budget;
    int frames = 0;                      ///< end after so many whole pictures; 0: when told to quit
    std::filesystem::path screenshot;    ///< gets the last picture of the window; "": none
    std::filesystem::path folder = ".";  ///< where F12 puts its pictures
    std::function<std::chrono::nanoseconds()> clock;  ///< never goes back; "": the steady clock
};

/// The loop of `luch view`: window, camera, and a renderer in the background. Times enter only as
/// the clock's differences, so it may run for ever and start anywhere.
class Viewer {
 public:
    Viewer(const Studio& studio, ViewerSetup setup, Window& window, std::ostream& out);

    /// Runs until the user quits, or the frames are made. What a technique threw is shown; with a
    /// number of frames it ends the loop. The first such exception is thrown again at the end.
    void run();

    /// One turn of the loop: waits up to `wait_ms` for events, then moves, renders and draws.
    void turn(int wait_ms);
    [[nodiscard]] bool done() const { return done_; }

    /// Whether the renderer came to rest within the limit, after run().
    [[nodiscard]] bool rests(std::chrono::milliseconds limit) const {
        return renderer_.wait(limit);
    }

    [[nodiscard]] const Camera& camera() const { return setup_.shot.camera; }
    [[nodiscard]] const std::string& technique() const { return entry().name; }
    /// What the window showed last.
    [[nodiscard]] const Image<Pixel>& picture() const { return picture_; }
    /// Whether the whole picture is there and nothing is left to do.
    [[nodiscard]] bool settled() const { return refinement_.settled() && !renderer_.busy(); }

 private:
    [[nodiscard]] const ViewerEntry& entry() const { return setup_.techniques[setup_.shown]; }
    [[nodiscard]] const ViewerEntry& other() const { return setup_.techniques[setup_.against]; }
    [[nodiscard]] double elapsed_s();
    void obey(Command command);
    void cycle(std::size_t by);
    void next_plane();
    void take_screenshot();
    void start_timing();
    void fly(const Input& input, double dt_s);
    void collect();
    void accept(RenderResult result);
    void accept_timing(const RenderResult& result);
    void report(std::exception_ptr failure);
    void render();
    void start(RenderRequest request);
    void develop_pictures();
    void draw();
    [[nodiscard]] std::vector<std::string> status() const;
    void restart();
    void say(std::string text);

    ViewerSetup setup_;
    Camera home_;
    Window* window_;
    std::ostream* out_;
    double speed_;
    std::chrono::nanoseconds now_{0}, started_{0};
    Size size_;  ///< of the window
    bool moving_ = false, dirty_ = true, done_ = false, help_ = false;
    bool marks_ = true, info_ = true;
    double split_ = 0.5;
    int frames_ = 0;
    std::string plane_;  ///< the plane shown; "": the colour
    Refinement refinement_;
    std::optional<RenderResult> result_;
    std::vector<Image<Pixel>> shown_;  ///< as they are pasted
    std::vector<std::string> notes_;   ///< below the status, until the picture changes
    std::string trouble_;
    std::exception_ptr failure_;
    Image<Pixel> picture_;
    Renderer renderer_;  // last: its thread ends before what it uses goes
};

}  // namespace luch
