#pragma once

#include "framework/technique/context.h"
#include "framework/technique/run.h"
#include "framework/window/window.h"

#include <chrono>
#include <functional>
#include <thread>

namespace luch::testing {

/// A unit sphere, seen from four units away, and everything to render it.
struct FakeStudio {
    Scene scene = sphere_scene();
    std::unique_ptr<Accelerator> accelerator = build_accelerator(scene);
    Workers workers{2};

    [[nodiscard]] Studio studio() const { return {scene, *accelerator, workers}; }

    static Scene sphere_scene() {
        Scene scene;
        scene.camera.position = {0, 0, -4};
        scene.geometries.emplace_back(Sphere{});
        scene.materials.emplace_back(Const{});
        add_node(scene, "ball", 0, 0, Transform{});
        return scene;
    }
};

/// A technique whose frames are made by a function.
class FakeTechnique : public Technique {
 public:
    using Render = std::function<void(const Shot&, Frame&, Context&)>;
    explicit FakeTechnique(Render render, std::string declines = "")
        : render_(std::move(render)), declines_(std::move(declines)) {}

    [[nodiscard]] Plan plan(const Scene&, const Shot&) const override {
        return {.applies = declines_.empty(), .why = declines_, .stages = {}};
    }
    void render(const Scene&, const Shot& shot, Frame& frame, Context& context) override {
        render_(shot, frame, context);
    }

 private:
    Render render_;
    std::string declines_;
};

/// Fills the frame.
inline FakeTechnique::Render painting(Rgb colour) {
    return [colour](const Shot&, Frame& frame, Context& context) {
        context.for_each_tile(frame.size(), [&](Tile tile, int) {
            for (int y = tile.y0; y < tile.y1; ++y) {
                for (int x = tile.x0; x < tile.x1; ++x) frame.colour(x, y) = colour;
            }
        });
    };
}

/// Never ends by itself.
inline FakeTechnique::Render endless() {
    return [](const Shot&, Frame&, Context& context) {
        while (!context.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
}

/// A window whose events are a list, and that keeps what it was shown.
class FakeWindow : public Window {
 public:
    explicit FakeWindow(Size inside) : inside_(inside) {}

    Input poll(int) override {
        ++polls;
        return std::exchange(next, {});
    }
    [[nodiscard]] Size size() const override { return inside_; }
    void show(ImageView<const Pixel> picture) override {
        ++shows;
        shown = picture.size();
    }
    void resize(Size inside) { inside_ = inside; }

    Input next;  ///< what the next poll() finds
    int polls = 0, shows = 0;
    Size shown;

 private:
    Size inside_;
};

/// Asks until it is so; false when it is not so after ten seconds.
inline bool eventually(const std::function<bool()>& so) {
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!so()) {
        if (std::chrono::steady_clock::now() > limit) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

}  // namespace luch::testing
