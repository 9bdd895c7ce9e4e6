#include "framework/stress/core.h"
#include "framework/stress/made/scenes.h"
#include "framework/stress/memory.h"
#include "framework/stress/things.h"
#include "framework/window/viewer.h"

#include <fmt/format.h>

#include <sstream>

namespace luch::stress {
namespace {

using namespace std::chrono_literals;

constexpr Rgb paint(0.75f, 0.5f, 0.25f);

/// Paints what a ray at each pixel's centre meets; the viewer's loop is tried, not a technique.
class Painter final : public Technique {
 public:
    [[nodiscard]] Plan plan(const Scene&, const Shot&) const override { return {}; }
    void render(const Scene&, const Shot& shot, Frame& frame, Context& context) override {
        const Screen screen(shot.camera, shot.size);
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            for (int y = tile.y0; y < tile.y1; ++y) {
                for (int x = tile.x0; x < tile.x1; ++x) {
                    const Ray ray = screen.ray(x + 0.5, y + 0.5);
                    const Hit hit = context.tracer(worker).closest(RayKind::primary, ray);
                    frame.colour(x, y) = hit ? paint * std::min(hit.t / 4, 1.0f) : Rgb(0);
                }
            }
        });
    }
};

/// A window that nobody sees; its events are what the case says.
class Unseen final : public Window {
 public:
    Input poll(int) override { return std::exchange(next, {}); }
    [[nodiscard]] Size size() const override { return {32, 24}; }
    void show(ImageView<const Pixel>) override {}

    Input next;
};

/// A viewer in that window, with a clock of its own that began long ago.
class Loop {
 public:
    Loop() : studio_(one_thing(Thing::ball), 1), viewer_(studio_.studio(), setup(), window_, out_) {
        press(Command::info);  // times are shown there
    }

    void turn(const Input& input) {
        window_.next = input;
        now_ += 16'666'667ns;
        viewer_.turn(0);
    }
    void press(Command command) {
        Input input;
        input.commands = {command};
        turn(input);
    }
    /// Turns until the whole picture is there; false when it never comes.
    bool settle() {
        for (int i = 0; i < 2000; ++i) {
            turn({});
            if (viewer_.settled()) return true;
            if (!viewer_.rests(10s)) return false;
        }
        return false;
    }
    /// There and back again.
    void fly() {
        for (const bool there : {true, false}) {
            Input input;
            (there ? input.keys.forward : input.keys.back) = true;
            (there ? input.keys.up : input.keys.down) = true;
            turn(input);
        }
    }
    [[nodiscard]] const Viewer& viewer() const { return viewer_; }

 private:
    ViewerSetup setup() {
        ViewerSetup setup;
        setup.techniques.push_back({"painter", std::make_unique<Painter>()});
        setup.shot = shot_of(studio_.scene());
        setup.clock = [this] { return now_; };
        return setup;
    }

    std::chrono::nanoseconds now_{1'000'000'000'000'000'000};
    OwnStudio studio_;
    Unseen window_;
    std::ostringstream out_;
    Viewer viewer_;
};

StressResult flown_and_back(int frames) {
    Loop loop;
    if (!loop.settle()) return {StressVerdict::fail, "the first picture never came"};
    const Image<Pixel> first = loop.viewer().picture();
    const Camera start = loop.viewer().camera();
    const int warm = std::min(frames / 2, 1000);
    std::uint64_t warm_bytes = 0;
    for (int i = 0; i < frames; ++i) {
        if (i == warm) warm_bytes = resident_bytes();
        loop.fly();
    }
    const std::uint64_t bytes = resident_bytes();
    const std::uint64_t growth = bytes > warm_bytes ? bytes - warm_bytes : 0;
    const double drift = max_norm(loop.viewer().camera().position - start.position);
    loop.press(Command::home);
    if (!loop.settle()) return {StressVerdict::fail, "the last picture never came"};
    const bool same = loop.viewer().picture() == first;
    // Each flight rounds a few times, and the errors add up at worst.
    const double most_drift = 16 * frames * 0x1p-52 * (1 + max_norm(start.position));
    const bool right = same && growth <= most_growth && drift <= most_drift;
    return {right ? StressVerdict::pass : StressVerdict::fail,
            fmt::format("{} turns, drift {:.1g}, grown by {} kB, {} picture", 2 * frames, drift,
                        growth >> 10, same ? "the same" : "another")};
}

}  // namespace

StressCase viewer_case(bool full) {
    return {20, "the viewer's loop, clock at 1e9 s", "no drift, ≤ 1 MB more, the first picture",
            [full] { return flown_and_back(full ? 500'000 : 1'000); }};
}

}  // namespace luch::stress
