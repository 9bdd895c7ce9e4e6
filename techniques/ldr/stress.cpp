#include "techniques/ldr/stress.h"

#include "framework/technique/run.h"

#include <fmt/format.h>

#include <limits>

namespace luch::techniques::ldr {
namespace {

constexpr int numbers_row = 18, frames_row = 12;

Scene under_sky(const Rgb& sky) {
    Scene scene;
    scene.settings = {.frame = {24, 18}, .ambient_light = Rgb(0), .background = sky};
    scene.settings.anti_aliasing = false;
    return scene;
}

/// A floor seen from above under suns of equal power that shine straight down.
Scene under_suns(int suns, float power) {
    Scene scene = under_sky(Rgb(0));
    scene.camera.pitch_deg = -90;
    scene.materials.emplace_back(Lambert{.color = Rgb(1)});
    scene.geometries.emplace_back(Plane{.y = -1});
    add_node(scene, "floor", 0, 0, Transform());
    for (int i = 0; i < suns; ++i) scene.lights.emplace_back(DirectionalLight{.power = power});
    return scene;
}

Outcome picture(const TechniqueInfo& info, const Scene& scene, int spp) {
    const auto accelerator = build_accelerator(scene);
    const Workers workers(2);
    Shot shot = shot_of(scene);
    shot.spp = spp;
    return run(*info.create(), {scene, *accelerator, workers}, shot, {}, {0, 1});
}

StressResult judged(const Outcome& outcome, bool right, std::string got) {
    if (!right) return {StressVerdict::fail, std::move(got)};
    if (outcome.unwritten.empty()) return {StressVerdict::pass, std::move(got)};
    return {StressVerdict::not_written, fmt::format("{}", fmt::join(outcome.unwritten, ", "))};
}

/// All pixels within a little of a grey.
StressResult all_near(const TechniqueInfo& info, const Scene& scene, int spp, float grey,
                      float tolerance) {
    const Outcome outcome = picture(info, scene, spp);
    float worst = 0;
    for (const Rgb& pixel : outcome.frame.colour.pixels()) {
        worst = std::max(worst, max_norm(pixel - Rgb(grey)));
    }
    return judged(outcome, worst <= tolerance, fmt::format("off by {:.4f} at most", worst));
}

StressResult all_counted(const TechniqueInfo& info, const Scene& scene) {
    const Outcome outcome = picture(info, scene, 1);
    const std::uint64_t pixels = outcome.frame.colour.pixels().size();
    return judged(outcome, outcome.non_finite.count == pixels,
                  fmt::format("{} of {} pixels counted", outcome.non_finite.count, pixels));
}

}  // namespace

std::vector<StressCase> stress_cases(const TechniqueInfo& info, bool full) {
    const float level = 2.3f / 255;  // of the screen, in linear light, where it is widest
    const int samples = full ? 4096 : 64, suns = full ? 5000 : 500;
    std::vector<StressCase> cases;
    cases.push_back({numbers_row, "a sky of 1e30 in words", "white",
                     [&info] { return all_near(info, under_sky(Rgb(1e30f)), 1, 1, 0); }});
    cases.push_back({numbers_row, "a sky of no number in words", "every pixel counted", [&info] {
                         constexpr float nan = std::numeric_limits<float>::quiet_NaN();
                         return all_counted(info, under_sky(Rgb(nan, 0.5f, 0.5f)));
                     }});
    cases.push_back({frames_row, fmt::format("{} samples of one colour", samples), "that colour",
                     [&info, samples, level] {
                         return all_near(info, under_sky(Rgb(0.25f)), samples, 0.25f, level);
                     }});
    cases.push_back({frames_row, fmt::format("{} suns of half of that part of white", suns),
                     "half of white", [&info, suns, level] {
                         const Scene scene = under_suns(suns, 0.5f / static_cast<float>(suns));
                         return all_near(info, scene, 1, 0.5f, level);
                     }});
    return cases;
}

}  // namespace luch::techniques::ldr
