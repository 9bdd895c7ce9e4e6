#include "techniques/ssao/stress.h"

#include "framework/technique/run.h"

#include <fmt/format.h>

namespace luch::techniques::ssao {
namespace {

const Rgb sky{0.1f, 0.2f, 0.4f};

Scene lit_by_all_around() {
    Scene scene;
    scene.settings.frame = {96, 72};
    scene.settings.ambient_light = Rgb(1);
    scene.settings.background = sky;
    return scene;
}

NodeId add(Scene& scene, Geometry geometry, const Transform& to_world = {}) {
    scene.geometries.push_back(std::move(geometry));
    scene.materials.emplace_back(Lambert{.color = Rgb(1)});
    return add_node(scene, "", static_cast<GeometryId>(scene.geometries.size() - 1),
                    static_cast<MaterialId>(scene.materials.size() - 1), to_world);
}

/// Balls on a floor before a wall; white, so that the picture is what arrives.
Scene still_life(double size = 1) {
    Scene scene = lit_by_all_around();
    scene.camera.position = size * Vec3d(0, 2, -6);
    scene.camera.pitch_deg = -15;
    add(scene, Plane{.limit = 30 * size});
    add(scene, Cube{.centre = size * Vec3d(0, 3, 4), .side = 6 * size});
    add(scene, Sphere{.centre = size * Vec3d(-1.2, 0.8, 0), .radius = 0.8 * size});
    add(scene, Sphere{.centre = size * Vec3d(0.8, 0.5, -1), .radius = 0.5 * size});
    return scene;
}

/// A board that fills the frame, turned from facing the eye, and a ball out of sight, so that there
/// is something to look for.
Scene tilted(double degrees) {
    Scene scene = lit_by_all_around();
    constexpr double radians = 3.14159265358979323846 / 180;
    add(scene, Plane{.limit = 1e3},
        Transform::rotation(0, (degrees - 90) * radians, 0)
            .then(Transform::translation({0, 0, 5})));
    add(scene, Sphere{.centre = {0, 0, -9}});
    return scene;
}

/// A box 100 in front of a wall.
Scene far_in_front() {
    Scene scene = lit_by_all_around();
    add(scene, Cube{.centre = {0, 0, 310}, .side = 400});
    add(scene, Cube{.centre = {3, 0, 12.5}, .side = 5});
    return scene;
}

Scene within(Scene scene, const std::function<void(Scene&)>& change) {
    change(scene);
    return scene;
}

Outcome picture(const TechniqueInfo& info, const Scene& scene, const Accelerator& accelerator,
                const std::string& radius, int threads) {
    const std::unique_ptr<Technique> technique = info.create();
    if (!radius.empty()) set_param(*technique, "radius=" + radius);
    Shot shot = shot_of(scene);
    shot.spp = 1;
    return run(*technique, {scene, accelerator, Workers(threads)}, shot, {}, {0, 1});
}

using Check = std::function<StressResult(const Outcome&)>;

/// What the case shows, and the radius; "": by the scene.
struct Look {
    std::function<Scene()> scene;
    std::string radius;
};

/// Finite, 0..1 of the ambient light, and the same on one thread and on several; then the check.
StressResult looked_at(const TechniqueInfo& info, const Scene& scene, const std::string& radius,
                       const Check& check) {
    const auto accelerator = build_accelerator(scene);
    const Outcome one = picture(info, scene, *accelerator, radius, 1);
    if (!one.plan.applies) return {StressVerdict::does_not_apply, one.plan.why};
    if (one.non_finite.count > 0) {
        return {StressVerdict::fail, fmt::format("{} pixels are not finite", one.non_finite.count)};
    }
    for (const Rgb& pixel : one.frame.colour.pixels()) {
        if (!(pixel.r >= 0 && pixel.r <= 1)) {
            return {StressVerdict::fail, fmt::format("{:.3g} of the light arrives", pixel.r)};
        }
    }
    if (picture(info, scene, *accelerator, radius, 3).frame.colour != one.frame.colour) {
        return {StressVerdict::fail, "other bits on 3 threads"};
    }
    StressResult result =
        check ? check(one) : StressResult{StressVerdict::pass, "finite, the same on 3 threads"};
    if (result.verdict == StressVerdict::pass && !one.unwritten.empty()) {
        result.verdict = StressVerdict::not_written;
    }
    return result;
}

StressResult judged(bool right, double darkest) {
    return {right ? StressVerdict::pass : StressVerdict::fail,
            fmt::format("at least {:.4f} of the light arrives", darkest)};
}

double darkest_of(const Outcome& outcome) {
    double darkest = 1;
    for (const Rgb& pixel : outcome.frame.colour.pixels()) {
        if (pixel != sky) darkest = std::min(darkest, double(pixel.r));
    }
    return darkest;
}

Check brighter_than(double least) {
    return [least](const Outcome& outcome) {
        return judged(darkest_of(outcome) >= least, darkest_of(outcome));
    };
}

Check darker_than(double most) {
    return [most](const Outcome& outcome) {
        return judged(darkest_of(outcome) < most, darkest_of(outcome));
    };
}

/// As many rays as there are pixels, however large the radius is.
StressResult a_ray_a_pixel(const Outcome& outcome) {
    const std::uint64_t rays = outcome.counts.all_rays();
    return {rays == outcome.frame.size().area() ? StressVerdict::pass : StressVerdict::fail,
            fmt::format("{} rays for {} pixels", rays, outcome.frame.size().area())};
}

StressResult only_sky(const Outcome& outcome) {
    const auto wrong = std::ranges::count_if(outcome.frame.colour.pixels(),
                                             [](const Rgb& pixel) { return pixel != sky; });
    return {wrong == 0 ? StressVerdict::pass : StressVerdict::fail,
            fmt::format("{} pixels wrong", wrong)};
}

}  // namespace

std::vector<StressCase> stress_cases(const TechniqueInfo& info, bool full) {
    std::vector<StressCase> cases;
    const auto add_case = [&](int row, std::string name, std::string expected, Look look,
                              Check check = {}) {
        cases.push_back({row, std::move(name), std::move(expected),
                         [info, look = std::move(look), check = std::move(check), full] {
                             Scene made = look.scene();
                             if (full && made.settings.frame.width == 96) {
                                 made.settings.frame = {640, 480};
                             }
                             return looked_at(info, made, look.radius, check);
                         }});
    };
    const auto still = [] { return still_life(); };
    for (const double degrees : {0.0, 45.0, 80.0}) {
        add_case(5, fmt::format("a board tilted by {}°", degrees), "hidden from nothing: > 0.99",
                 {[degrees] { return tilted(degrees); }, "1"}, brighter_than(0.99));
    }
    add_case(5, "an edge 100 in front", "no halo: > 0.999", {far_in_front, "5"},
             brighter_than(0.999));
    add_case(8, "a radius below a pixel", "all light arrives", {still, "1e-4"}, brighter_than(1));
    for (const char* radius : {"100", "1e9", "1e15"}) {
        add_case(8, fmt::format("a radius of {}", radius), "a ray a pixel", {still, radius},
                 a_ray_a_pixel);
    }
    for (const double size : {1e-6, 1e6}) {
        add_case(8, fmt::format("a scene {:.0e} times as large", size), "dark in corners: < 0.8",
                 {[size] { return still_life(size); }, ""}, darker_than(0.8));
    }
    add_case(12, "a still life", "dark in corners: < 0.8", {still, ""}, darker_than(0.8));
    add_case(12, "nothing but the sky", "the sky everywhere", {lit_by_all_around, ""}, only_sky);
    for (const Size size : {Size{1, 1}, Size{1, 33}, Size{67, 7}}) {
        add_case(
            12, fmt::format("occluded, {} × {} pixels", size.width, size.height),
            "finite, threads agree",
            {[size] { return within(still_life(), [size](Scene& s) { s.settings.frame = size; }); },
             ""});
    }
    add_case(13, "samples off the screen", "finite, threads agree",
             {[] { return within(still_life(), [](Scene& s) { s.camera.yaw_deg = 70; }); }, "3"});
    add_case(
        13, "an eye on the floor", "finite, threads agree",
        {[] { return within(still_life(), [](Scene& s) { s.camera.position.y = 1e-9; }); }, ""});
    add_case(
        13, "an eye inside of a ball", "finite, threads agree",
        {[] {
             return within(still_life(), [](Scene& s) { s.camera.position = {-1.2, 0.8, 0.1}; });
         },
         ""});
    add_case(13, "occluded, 179° wide", "finite, threads agree",
             {[] { return within(still_life(), [](Scene& s) { s.camera.fov_deg = 179; }); }, ""});
    add_case(13, "occluded, 0.0001° wide", "finite, threads agree",
             {[] { return within(still_life(), [](Scene& s) { s.camera.fov_deg = 1e-4; }); }, ""});
    return cases;
}

}  // namespace luch::techniques::ssao
