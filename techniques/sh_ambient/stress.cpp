#include "techniques/sh_ambient/stress.h"

#include "framework/stress/made/scenes.h"
#include "techniques/sh_ambient/sh_ambient.h"

#include <fmt/format.h>

#include <limits>

namespace luch::techniques::sh_ambient {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

/// A sky of one grey but for one texel above.
CubemapEnvironment sky_with(const Rgb& sun, float grey = 0.25f) {
    CubemapEnvironment sky;
    for (Image<Rgb>& side : sky.sides) side = Image<Rgb>({9, 9}, Rgb(grey));
    sky.sides[CubemapEnvironment::pos_y](4, 4) = sun;
    return sky;
}

/// A ball on a floor, seen from above: no sky in the picture.
Scene ball(std::optional<Environment> sky) {
    Scene scene = stress::empty_scene();
    scene.settings.frame = {64, 48};
    scene.lights.clear();
    scene.camera.position = {0, 6, 0};
    scene.camera.pitch_deg = -90;
    stress::add_shape(scene, Sphere{}, {}, Rgb(0.5f));
    stress::add_shape(scene, Plane{.y = -1, .limit = 20}, {}, Rgb(0.5f));
    scene.environment = std::move(sky);
    return scene;
}

/// A room with a lamp in it, and a dark one beside it behind a thin wall; the camera is in the
/// latter.
Scene dark_room() {
    Scene scene = stress::empty_scene();
    scene.settings.frame = {64, 48};
    scene.lights = {PointLight{.position = {-1, 0.3, 0.2}, .power = 1}};
    scene.camera.position = {1.8, 0, 0};
    scene.camera.yaw_deg = 90;
    const auto box = [&](const Vec3d& size) {
        stress::add_shape(scene, Cube{}, Transform::scaling(size), Rgb(0.5f));
    };
    box({4, 2, 2});
    box({0.02, 2, 2});
    return scene;
}

using Check = std::function<StressResult(const Outcome&)>;

StressResult judged(bool right, std::string got) {
    return {right ? StressVerdict::pass : StressVerdict::fail, std::move(got)};
}

Outcome picture(const TechniqueInfo& info, const Scene& scene, const std::string& mode,
                int threads) {
    const std::unique_ptr<Technique> technique = info.create();
    set_param(*technique, mode);
    if (mode == "mode=probes") set_param(*technique, "rays=64");
    if (mode == "mode=sampled" || mode == "mode=traced") set_param(*technique, "samples=16");
    return stress::OwnStudio(scene, threads).render(*technique);
}

/// Finite and the same on one thread and on several, in this mode; then the check.
StressResult looked_at(const TechniqueInfo& info, const Scene& scene, const std::string& mode,
                       const Check& check) {
    const Outcome one = picture(info, scene, mode, 1);
    if (!one.plan.applies) return {StressVerdict::does_not_apply, one.plan.why};
    if (one.non_finite.count > 0) {
        return judged(false, fmt::format("{} pixels are not finite", one.non_finite.count));
    }
    if (picture(info, scene, mode, 3).frame.colour != one.frame.colour) {
        return judged(false, "other bits on 3 threads");
    }
    StressResult result = check ? check(one) : judged(true, "finite, the same on 3 threads");
    if (result.verdict == StressVerdict::pass && !one.unwritten.empty()) {
        result.verdict = StressVerdict::not_written;
    }
    return result;
}

struct Range {
    float least = inf, most = -inf;
};

Range range_of(const Outcome& outcome) {
    Range range;
    for (const Rgb& pixel : outcome.frame.colour.pixels()) {
        range.least = std::min({range.least, pixel.x, pixel.y, pixel.z});
        range.most = std::max({range.most, pixel.x, pixel.y, pixel.z});
    }
    return range;
}

/// No channel below 0, and none above.
Check within(float most) {
    return [most](const Outcome& outcome) {
        const Range range = range_of(outcome);
        return judged(range.least >= 0 && range.most <= most,
                      fmt::format("{:.3g}…{:.3g}", range.least, range.most));
    };
}

/// The mean is no larger.
Check dark(float most) {
    return [most](const Outcome& outcome) {
        Vec3d sum(0);
        for (const Rgb& pixel : outcome.frame.colour.pixels()) sum += Vec3d(pixel);
        const double mean = max_norm(sum) / static_cast<double>(outcome.frame.size().area());
        return judged(mean <= most, fmt::format("{:.2g} on average, {:.2g} at most", mean,
                                                range_of(outcome).most));
    };
}

/// The picture with another sky in the place of this one, bit for bit.
Check as_under(const TechniqueInfo& info, const CubemapEnvironment& sky, const std::string& mode) {
    return [info, sky, mode](const Outcome& outcome) {
        const Outcome other = picture(info, ball(sky), mode, 1);
        const std::size_t off = stress::different_pixels(outcome, other);
        return judged(off == 0, fmt::format("{} pixels differ", off));
    };
}

/// A list of cases in the making.
struct Cases {
    TechniqueInfo info;
    bool full;
    std::vector<StressCase> list;

    void add(int row, std::string name, std::string expected, const std::string& mode,
             std::function<Scene()> scene, Check check = {}) {
        list.push_back(
            {row, std::move(name), std::move(expected),
             [of = info, size = full, mode, scene = std::move(scene), check = std::move(check)] {
                 Scene made = scene();
                 if (size) made.settings.frame = {320, 240};
                 return looked_at(of, made, mode, check);
             }});
    }
};

void add_skies(Cases& cases) {
    const std::string mode = "mode=environment";
    for (const float power : {1e6f, 1e30f}) {
        cases.add(
            18, fmt::format("a sun of {:.0e} in the sky", power), "finite, nowhere below 0", mode,
            [power] { return ball(sky_with(Rgb(power))); }, within(power));
    }
    for (const float wild : {nan, inf, -inf}) {
        // At its own size: the other picture is made at the quick one.
        cases.add(
            18, fmt::format("ambient light of a texel of {:g}", wild), "as of a black one", mode,
            [wild] { return ball(sky_with(Rgb(wild, 1, 1))); },
            cases.full ? Check{} : as_under(cases.info, sky_with(Rgb(0)), mode));
    }
    cases.add(
        18, "a sky of 1e-38", "finite, nowhere below 0", mode,
        [] { return ball(sky_with(Rgb(1e-38f), 1e-38f)); }, within(1e-37f));
    cases.add(
        12, "a sky of no pixels", "black", mode, [] { return ball(CubemapEnvironment{}); },
        within(0));
    cases.add(
        12, "no sky and no lights", "black", mode, [] { return ball(std::nullopt); }, within(0));
}

void add_probes(Cases& cases) {
    const std::string mode = "mode=probes";
    cases.add(12, "probes, an endless floor alone", "finite, threads agree", mode, [] {
        Scene scene = ball(sky_with(Rgb(1)));
        scene.nodes.erase(scene.nodes.begin());
        std::get<Plane>(scene.geometries[1]).limit = inf;
        return scene;
    });
    cases.add(12, "probes, one triangle, which is flat", "finite, threads agree", mode, [] {
        Scene scene = stress::one_triangle();
        scene.settings.background = Rgb(0.5f);
        return scene;
    });
    for (const double size : {1e-12, 1e12}) {
        cases.add(
            3, fmt::format("probes, a scene {:.0e} large", size), "no brighter than its sky", mode,
            [size] {
                Scene scene = ball(ConstantEnvironment{Rgb(0.5f)});
                for (Node& node : scene.nodes) {
                    node.to_world = Transform::scaling(Vec3d(size));
                    node.to_object = node.to_world.inverse();
                }
                scene.camera.position *= size;
                return scene;
            },
            within(0.51f));
    }
    cases.add(
        18, "probes under a sun of 1e30", "finite, nowhere below 0", mode,
        [] { return ball(sky_with(Rgb(1e30f))); }, within(1e30f));
    cases.add(
        18, "probes, a texel of NaN", "finite, nowhere below 0", mode,
        [] { return ball(sky_with(Rgb(nan))); }, within(0.3f));
    cases.add(17, "probes between mirrors face to face", "finite, threads agree", mode, [] {
        Scene scene = dark_room();
        scene.materials[0] = Reflection{.multiplier = Rgb(1)};
        return scene;
    });
    // The lit room's walls send about 0.4 on.
    cases.add(5, "a dark room beside a lit one", "1 % of the lit one's light on average", mode,
              dark_room, dark(0.004f));
}

}  // namespace

std::vector<StressCase> stress_cases(const TechniqueInfo& info, bool full) {
    Cases cases{info, full, {}};
    add_skies(cases);
    add_probes(cases);
    for (const char* mode : {"mode=probes", "mode=sampled", "mode=traced"}) {
        for (const Size size : {Size{1, 1}, Size{1, 33}, Size{67, 7}}) {
            cases.add(12, fmt::format("{}, {} × {} pixels", mode, size.width, size.height),
                      "finite, threads agree", mode, [size] {
                          Scene scene = ball(sky_with(Rgb(2)));
                          scene.settings.frame = size;
                          return scene;
                      });
        }
    }
    return std::move(cases.list);
}

}  // namespace luch::techniques::sh_ambient
