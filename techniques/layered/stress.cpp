#include "techniques/layered/stress.h"

#include "framework/technique/run.h"

#include <fmt/format.h>

namespace luch::techniques::layered {
namespace {

/// Three balls one behind the other, the middle one in focus.
Scene balls() {
    Scene scene;
    scene.settings.frame = {96, 72};
    scene.settings.ambient_light = Rgb(0.2f);
    scene.settings.background = {0.1f, 0.2f, 0.4f};
    scene.camera.depth_of_field = true;
    scene.camera.f_number = 16;
    scene.camera.focal_distance = 8;
    scene.lights.emplace_back(PointLight{.position = {-3, 6, -2}, .power = 60});
    scene.geometries.emplace_back(Sphere{});
    const auto add = [&](const Rgb& colour, const Vec3d& at) {
        scene.materials.emplace_back(Lambert{.color = colour});
        add_node(scene, "", 0, static_cast<MaterialId>(scene.materials.size() - 1),
                 Transform::translation(at));
    };
    add({0.7f, 0.2f, 0.1f}, {-1.2, -0.3, 4});
    add({0.2f, 0.7f, 0.2f}, {0.3, 0, 8});
    add({0.2f, 0.3f, 0.8f}, {3, 1, 20});
    return scene;
}

Scene lamp_of(float power) {
    Scene scene = balls();
    scene.materials[2] = Const{Rgb(power)};
    return scene;
}

template <class Change>
Scene changed(Change&& change) {
    Scene scene = balls();
    change(scene);
    return scene;
}

Outcome picture(const TechniqueInfo& info, const Scene& scene, const Accelerator& accelerator,
                int threads) {
    const std::unique_ptr<Technique> technique = info.create();
    const Workers workers(threads);
    return run(*technique, {scene, accelerator, workers}, shot_of(scene), {}, {0, 1});
}

using Check = std::function<StressResult(const Outcome&)>;

/// Finite and the same on one thread and on several; then the check.
StressResult looked_at(const TechniqueInfo& info, const Scene& scene, const Check& check) {
    const auto accelerator = build_accelerator(scene);
    const Outcome one = picture(info, scene, *accelerator, 1);
    if (!one.plan.applies) return {StressVerdict::does_not_apply, one.plan.why};
    if (one.non_finite.count > 0) {
        return {StressVerdict::fail, fmt::format("{} pixels are not finite", one.non_finite.count)};
    }
    if (picture(info, scene, *accelerator, 3).frame.colour != one.frame.colour) {
        return {StressVerdict::fail, "other bits on 3 threads"};
    }
    StressResult result =
        check ? check(one) : StressResult{StressVerdict::pass, "finite, the same on 3 threads"};
    if (result.verdict == StressVerdict::pass && !one.unwritten.empty()) {
        result.verdict = StressVerdict::not_written;
    }
    return result;
}

/// No pixel brighter than the brightest thing that is there.
Check no_brighter_than(float most) {
    return [most](const Outcome& outcome) {
        float brightest = 0;
        for (const Rgb& pixel : outcome.frame.colour.pixels()) {
            brightest = std::max(brightest, max_norm(pixel));
        }
        return StressResult{brightest <= most * 1.0001f ? StressVerdict::pass : StressVerdict::fail,
                            fmt::format("at most {:.3g}", brightest)};
    };
}

Check everywhere(const Rgb& colour) {
    return [colour](const Outcome& outcome) {
        std::size_t wrong = 0;
        for (const Rgb& pixel : outcome.frame.colour.pixels()) {
            wrong += max_norm(pixel - colour) <= 1e-5f ? 0 : 1;
        }
        return StressResult{wrong == 0 ? StressVerdict::pass : StressVerdict::fail,
                            fmt::format("{} pixels wrong", wrong)};
    };
}

}  // namespace

std::vector<StressCase> stress_cases(const TechniqueInfo& info, bool full) {
    std::vector<StressCase> cases;
    const auto add = [&](int row, std::string name, std::string expected,
                         std::function<Scene()> scene, Check check = {}) {
        cases.push_back({row, std::move(name), std::move(expected),
                         [info, scene = std::move(scene), check = std::move(check), full] {
                             Scene made = scene();
                             if (full) made.settings.frame = {640, 480};
                             return looked_at(info, made, check);
                         }});
    };
    const auto camera = [](auto&& change) {
        return [change] { return changed([&](Scene& scene) { change(scene.camera); }); };
    };
    add(
        12, "a lens and nothing to see", "the sky everywhere",
        [] { return changed([](Scene& scene) { scene.nodes.clear(); }); },
        everywhere({0.1f, 0.2f, 0.4f}));
    for (const Size size : {Size{1, 1}, Size{1, 33}, Size{67, 7}}) {
        add(12, fmt::format("a lens, {} × {} pixels", size.width, size.height),
            "finite, threads agree",
            [size] { return changed([size](Scene& scene) { scene.settings.frame = size; }); });
    }
    add(13, "a ball that touches the lens", "finite, threads agree", [] {
        return changed([](Scene& scene) {
            add_node(scene, "", 0, 0, Transform::translation({0.2, 0, 1.0001}));
        });
    });
    add(13, "a lens inside a ball", "finite, threads agree", camera([](Camera& c) {
            c.position = {0.3, 0, 8.2};
        }));
    for (const double f : {0.5, 128.0}) {
        add(13, fmt::format("f/{}", f), "finite, threads agree",
            camera([f](Camera& c) { c.f_number = f; }));
    }
    for (const double distance : {1e-3, 1e6}) {
        add(13, fmt::format("focus at {:.0e}", distance), "finite, threads agree",
            camera([distance](Camera& c) { c.focal_distance = distance; }));
    }
    add(13, "a lens, 179° wide", "finite, threads agree",
        camera([](Camera& c) { c.fov_deg = 179; }));
    add(
        18, "a lamp of 1e30 out of focus", "no brighter than itself", [] { return lamp_of(1e30f); },
        no_brighter_than(1e30f));
    add(18, "a black lamp out of focus", "finite, threads agree", [] { return lamp_of(0); });
    return cases;
}

}  // namespace luch::techniques::layered
