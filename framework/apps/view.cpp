#include "framework/apps/marked.h"
#include "framework/apps/session.h"
#include "framework/apps/verbs.h"
#include "framework/base/error.h"
#include "framework/technique/catalogue.h"
#include "framework/window/viewer.h"

#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace luch {
namespace {

/// A technique that looks at its cancel token too rarely would hold the window after Esc; past this
/// the process ends without it, and the system closes the window. Nothing is left to be saved.
constexpr std::chrono::milliseconds patience_at_the_end{50};

class View final : public Verb {
 public:
    [[nodiscard]] std::string_view name() const override { return "view"; }
    [[nodiscard]] std::string_view summary() const override {
        return "a window to fly through a scene and compare techniques";
    }
    [[nodiscard]] std::string_view examples() const override {
        return "  luch view scenes/room/room.scene\n"
               "      fly through a scene with the classic tracer\n"
               "  luch view scenes/room/room.scene -t vista --against baseline\n"
               "      begin with the wiper between two techniques\n"
               "  luch view scenes/room/room.scene --frames 3 --screenshot view.png\n"
               "      three frames and a picture of the window; works without a display\n"
               "Keys:\n"
               "  W A S D, arrows   fly; with Shift faster; E Q or PgUp PgDn: up, down\n"
               "  drag the mouse    look around; wheel, + -: fly faster, slower from now on\n"
               "  R, Home           back to the scene's camera\n"
               "  Tab, Shift+Tab    next, previous technique of the catalogue\n"
               "  C, Space          compare: the mouse moves the wiper between the two\n"
               "  P                 next plane of the frame (ids, depth...), then the colour\n"
               "  M, I              marks, the text along the bottom: on and off\n"
               "  F5                time the frame, 7 times, against the other technique\n"
               "  F12               save the window as luch-view-NNN.png\n"
               "  H, F1             help; Esc: quit\n";
    }

    void declare(Arguments& arguments) override {
        arguments.positional("SCENE", scene_, "the scene file");
        arguments.option("-t,--technique", technique_, "NAME",
                         "what to show first, see luch list [baseline]");
        arguments.option("-p,--param", params_, "KEY=VALUE", "a parameter of that technique");
        arguments.option("--against", against_, "NAME",
                         "begin with the wiper, this technique on its right [baseline]");
        arguments.option("--frames", frames_, "N", "end after N frames [until Esc]");
        arguments.option("--screenshot", screenshot_, "FILE", "save the window's last picture");
        arguments.option("--pixel", pixel_, "X,Y",
                         "draw squares around this pixel of the frame; a small frame is enlarged");
        options_.declare(arguments);
    }

    int run() override {
        const bool offscreen = !screen_present();
        check(offscreen);
        const Session session(scene_, options_);
        ViewerSetup chosen = setup(session);
        const std::unique_ptr<Window> window =
            open_window("luch view " + scene_, chosen.shot.size, offscreen);
        Viewer viewer(session.studio(), std::move(chosen), *window, std::cout);
        viewer.run();
        if (!viewer.rests(patience_at_the_end)) {
            std::cout.flush();
            std::_Exit(EXIT_SUCCESS);
        }
        return EXIT_SUCCESS;
    }

 private:
    /// Before a scene is loaded, which may take long.
    void check(bool offscreen) {
        find_technique(technique_);
        find_technique(against());
        if (frames_ < 0) throw Error("--frames: give 1 or more");
        if (!offscreen) return;
        if (frames_ == 0 && screenshot_.empty()) {
            throw Error(
                "there is no display to open a window on (neither DISPLAY nor WAYLAND_DISPLAY is "
                "set, or SDL_VIDEODRIVER shows nothing); add --frames N or --screenshot FILE to do "
                "without one, or use luch render");
        }
        if (frames_ == 0) frames_ = 1;
        std::cerr << "luch view: no display, going on offscreen\n";
    }

    [[nodiscard]] std::string against() const { return against_.empty() ? "baseline" : against_; }

    [[nodiscard]] ViewerSetup setup(const Session& session) const {
        const TechniqueInfo& shown = find_technique(technique_);
        const TechniqueInfo& other = find_technique(against());
        ViewerSetup setup;
        for (const TechniqueInfo& info : catalogue()) {
            if (info.name == shown.name) setup.shown = setup.techniques.size();
            if (info.name == other.name) setup.against = setup.techniques.size();
            const bool first = info.name == shown.name;
            setup.techniques.push_back(
                {std::string(info.name),
                 first ? make_technique(technique_, params_) : info.create()});
        }
        setup.compare = !against_.empty();
        setup.shot = session.shot();
        if (!pixel_.empty()) mark(setup);
        setup.budget = session.budget();
        setup.frames = frames_;
        setup.screenshot = screenshot_;
        return setup;
    }

    /// Tests are on small frames: their pixels must be seen.
    void mark(ViewerSetup& setup) const {
        constexpr int wide_enough = 640;
        Size& size = setup.shot.size;
        const MarkedPixel pixel = parsed_pixel(pixel_, size);
        const int times = std::max(1, wide_enough / size.width);
        size = {times * size.width, times * size.height};
        for (auto& choice : setup.techniques) {
            choice.technique = marked(std::move(choice.technique), pixel);
        }
    }

    SceneOptions options_;
    std::string scene_, technique_ = "baseline", against_, screenshot_, pixel_;
    std::vector<std::string> params_;
    int frames_ = 0;
};

}  // namespace

std::unique_ptr<Verb> make_view() {
    return std::make_unique<View>();
}

}  // namespace luch
