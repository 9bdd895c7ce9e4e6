#pragma once

#include "framework/math/rng.h"
#include "framework/technique/catalogue.h"
#include "framework/technique/context.h"

#include <array>
#include <atomic>
#include <cmath>

// Techniques whose errors are known by heart.
namespace luch::testing {

/// Frames that any toy has made in this process.
inline std::atomic<int> toy_frames{0};

/// A pixel is the mean of its samples, each uniform in 0..0.5: unbiased, mean 0.25, the error falls
/// with the power −½ of their number. One sample is the pixel's centre: 0.25, without noise.
class Noisy : public Technique {
 public:
    Plan plan(const Scene&, const Shot&) const override {
        return {
            .applies = true,
            .why = "",
            .stages = {
                {.name = "idle", .needed = false, .kind = Stage::exact, .why = "toy", .bound = 0}}};
    }
    void render(const Scene&, const Shot& shot, Frame& frame, Context& context) override {
        ++toy_frames;
        for (int y = 0; y < shot.size.height; ++y) {
            for (int x = 0; x < shot.size.width; ++x) frame.colour(x, y) = pixel(shot, x, y);
        }
        context.tracer(0).counts().of(RayKind::primary) += shot.size.area();
    }

 private:
    static Rgb pixel(const Shot& shot, int x, int y) {
        if (shot.spp <= 1) return Rgb(0.25f);
        const Key key = Key(shot.seed).branch(static_cast<std::uint64_t>(1000 * y + x));
        double sum = 0;
        for (int i = 0; i < shot.spp; ++i) sum += key.uniform(static_cast<std::uint64_t>(i));
        return Rgb(static_cast<float>(0.5 * sum / shot.spp));
    }
};

/// Grey everywhere: 0.25, off by its parameter.
class Off : public Technique {
 public:
    void visit(ParamVisitor& visitor) override {
        visitor.visit({"error", "", "how far off"}, error_, 0, 1);
    }
    Plan plan(const Scene&, const Shot&) const override { return {}; }
    void render(const Scene&, const Shot& shot, Frame& frame, Context& context) override {
        ++toy_frames;
        frame.colour = Image<Rgb>(shot.size, Rgb(static_cast<float>(0.25 + error_)));
        context.tracer(0).counts().of(RayKind::primary) += shot.size.area();
    }

 private:
    double error_ = 0;
};

template <class T>
std::unique_ptr<Technique> create() {
    return std::make_unique<T>();
}

inline constexpr std::array<double, 3> off_by{0.5, 0.25, 0};
inline const TechniqueInfo noisy{
    "noisy", "a noisy one", "", create<Noisy>, {samples_parameter, samples_sweep, -0.5}};
inline const TechniqueInfo off{"off", "one that is off", "", create<Off>, {"error", off_by}};

}  // namespace luch::testing
