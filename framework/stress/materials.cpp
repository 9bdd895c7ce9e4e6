#include "framework/stress/made/everything.h"
#include "framework/stress/subject.h"
#include "framework/stress/things.h"

#include <fmt/format.h>

namespace luch::stress {
namespace {

const Rgb sky(0.25f, 0.5f, 0.75f);

Scene before_sky() {
    Scene scene = one_thing(Thing::ball);
    scene.settings.background = sky;
    return scene;
}

/// A thing in front of a lit ball, and the sky.
Scene in_front(const Material& material, Thing thing = Thing::sphere) {
    Scene scene = before_sky();
    add(scene, thing, material,
        Transform::scaling(Vec3d(0.5)).then(Transform::translation({0.1, 0.6, -1.5})));
    return scene;
}

/// The same, but the ball shines by itself: a clear thing throws a shadow as any other.
Scene shining(bool behind_glass) {
    Scene scene = before_sky();
    scene.materials[0] = Const{.color = {0.75f, 0.5f, 0.25f}};
    if (!behind_glass) return scene;
    add(scene, Sphere{.centre = {0.1, 0.6, -1.5}, .radius = 0.5},
        Refraction{.multiplier = Rgb(1), .ior = 1});
    return scene;
}

/// Within a box of mirrors that no light comes into.
Scene in_mirrors(int max_depth) {
    Scene scene;
    scene.settings = {.frame = {24, 18}, .ambient_light = Rgb(0), .background = sky};
    scene.settings.anti_aliasing = false;
    scene.settings.max_depth = max_depth;
    // Not at round numbers: a path that meets an edge of the box exactly may leak there.
    scene.camera.position = {0.1234567, 0.2345678, -0.3456789};
    add(scene, Thing::cube, Reflection{.multiplier = Rgb(1)});
    return scene;
}

/// In a ball that shines, with the lamp in the camera: where a highlight is at its peak everywhere.
Scene in_highlight(double exponent) {
    Scene scene = one_thing(Thing::sphere);
    scene.camera.position = {0, 0, 0};
    scene.lights[0] = PointLight{.position = {0, 0, 0}, .power = 1};
    scene.materials[0] = Phong{.color = Rgb(0.25f), .specular = Rgb(0.5f), .exponent = exponent};
    return scene;
}

/// A ball and a ceiling of small squares over a floor that mirrors them.
Scene over_mirror(double glossiness) {
    Scene scene = before_sky();
    scene.textures.emplace_back(CheckerTexture{.scaling = 0.25});
    // It ends: at the horizon a jitter of 1e-6 is larger than a square.
    add(scene, Plane{.y = 3, .limit = 100}, Lambert{.texture = 0});
    add(scene, Plane{.y = -1}, Reflection{.glossiness = glossiness, .samples = 4});
    return scene;
}

/// Two mirrors face to face, a lit ball between them.
Scene between_mirrors(int max_depth, double glossiness) {
    Scene scene = one_thing(Thing::ball);
    scene.settings.frame = {24, 18};
    scene.settings.background = sky;
    scene.settings.max_depth = max_depth;
    const Reflection mirror{.multiplier = Rgb(1), .glossiness = glossiness, .samples = 2};
    for (const double z : {-4.0, 4.0}) {
        add(scene, Plane{.y = 0, .limit = 6}, mirror,
            Transform::rotation(0, 1.5707963267948966, 0).then(Transform::translation({0, 0, z})));
    }
    return scene;
}

/// No ray goes on more often than the depth allows, and `more` times.
StressResult bounded(const Sight& sight, std::uint64_t more) {
    const auto& counts = sight.outcome.counts;
    const std::uint64_t bounced = counts.of(RayKind::reflection) + counts.of(RayKind::glossy) +
                                  counts.of(RayKind::refraction) + counts.of(RayKind::gi);
    const auto depth = static_cast<std::uint64_t>(sight.scene.settings.max_depth) + more;
    const std::uint64_t most =
        depth * sight.shot.size.area() * static_cast<std::uint64_t>(std::max(sight.shot.spp, 1));
    return judged(bounced <= most, fmt::format("{} bounces, {} at most", bounced, most));
}

/// No light comes in, and no ray goes on for ever.
StressResult black_and_bounded(const Sight& sight) {
    const StressResult black = all_of(Rgb(0))(sight);
    return black.verdict == StressVerdict::pass ? bounded(sight, 0) : black;
}

/// Under water, looking up so far from the horizon, in degrees; nothing but water and sky.
Scene under_water(double pitch_deg, double fov_deg) {
    Scene scene;
    scene.settings = {.frame = {24, 18}, .ambient_light = Rgb(0), .background = sky};
    scene.settings.anti_aliasing = false;
    scene.camera.position = {0, -1, 0};
    scene.camera.pitch_deg = pitch_deg;
    scene.camera.fov_deg = fov_deg;
    add(scene, Plane{.y = 0}, Refraction{.multiplier = Rgb(1), .ior = 1.5});
    return scene;
}

Scene nested_glass(int shells, int max_depth) {
    Scene scene = before_sky();
    scene.settings.max_depth = max_depth;
    for (int i = 0; i < shells; ++i) {
        add(scene, Sphere{.centre = {0, 0.6, -1.5}, .radius = 0.5 * (shells - i) / shells},
            Refraction{.ior = i % 2 == 0 ? 1.5 : 1.25, .absorption = 0.5});
    }
    return scene;
}

/// A ball whose layers are mirrors and paints over one another.
Scene layered(int layers, double ior) {
    Scene scene = before_sky();
    Layered all;
    scene.textures.emplace_back(Fresnel{.ior = ior});
    const auto fresnel = static_cast<TextureId>(scene.textures.size() - 1);
    for (int i = 0; i < layers; ++i) {
        if (i % 2 == 0) {
            scene.materials.emplace_back(Lambert{});
        } else {
            scene.materials.emplace_back(Reflection{});
        }
        all.layers.push_back(
            {static_cast<MaterialId>(scene.materials.size() - 1), Rgb(0.5f), fresnel});
    }
    add(scene, Thing::sphere, all, Transform::translation({0, 0, -1}));
    return scene;
}

Scene bumped(double strength) {
    Scene scene = before_sky();
    scene.textures.emplace_back(Bumps{.strength = strength});
    scene.nodes[0].bump = static_cast<TextureId>(scene.textures.size() - 1);
    return scene;
}

void add_glass(CaseList& list) {
    list.look(
        17, "glass of ior 1", "as if it were not there", [] { return shining(true); },
        as_of([] { return shining(false); }, 0.01));
    for (const double ior : {1e-6, 1 + 1e-9, 10.0, 1e6}) {
        list.look(17, fmt::format("glass of ior {:.10g}", ior), "finite",
                  [ior] { return in_front(Refraction{.ior = ior}); });
    }
    list.look(
        17, "total internal reflection", "black", [] { return under_water(15, 20); },
        all_of(Rgb(0)));
    list.look(
        17, "straight up out of water", "the sky", [] { return under_water(90, 20); }, all_of(sky));
    list.look(17, "glass in glass in glass", "finite", [] { return nested_glass(3, 8); });
    list.look(17, "thirty shells of glass, depth 64", "finite",
              [] { return nested_glass(30, 64); });
    list.look(17, "glass that absorbs 1e30", "finite",
              [] { return in_front(Refraction{.inside_color = Rgb(0.5f), .absorption = 1e30}); });
}

void add_mirrors(CaseList& list) {
    for (const int depth : {0, 8, 200}) {
        list.look(
            17, fmt::format("in a box of mirrors, depth {}", depth), "black, a ray a bounce",
            [depth] { return in_mirrors(depth); }, black_and_bounded);
    }
    for (const int depth : {1, 8, 200}) {
        list.look(
            17, fmt::format("mirrors face to face, depth {}", depth), "a ray a bounce",
            [depth] { return between_mirrors(depth, 1); },
            // At the last surface a path tracer looks round for lights.
            [](const Sight& sight) { return bounded(sight, 1); });
    }
    list.look(17, "glossy mirrors face to face", "finite", [] { return between_mirrors(3, 0.75); });
    list.look(
        17, "glossiness 1 − 1e-7", "as a mirror", [] { return over_mirror(1 - 1e-7); },
        as_of([] { return over_mirror(1); }, 0.02));
    list.look(17, "glossiness 0", "finite",
              [] { return in_front(Reflection{.glossiness = 0, .samples = 4}); });
    list.look(17, "a mirror that multiplies by 1e4", "finite", [] {
        Scene scene = between_mirrors(8, 1);
        for (Material& material : scene.materials) {
            if (auto* mirror = std::get_if<Reflection>(&material)) mirror->multiplier = Rgb(1e4f);
        }
        return scene;
    });
}

}  // namespace

void add_materials(CaseList& list) {
    add_mirrors(list);
    add_glass(list);
    for (const double exponent : {0.0, 1e-30, 1e6, 1e30}) {
        list.look(17, fmt::format("a highlight of exponent {:g}", exponent), "finite",
                  [exponent] { return in_front(Phong{.exponent = exponent}); });
        list.look(17, fmt::format("a highlight of exponent {:g}, at its peak", exponent), "finite",
                  [exponent] { return in_highlight(exponent); });
    }
    for (const double ior : {1e-6, 1.0, 1e6}) {
        list.look(17, fmt::format("64 layers, Fresnel of ior {:g}", ior), "finite",
                  [ior] { return layered(64, ior); });
    }
    for (const double strength : {1e-30, 1e6}) {
        list.look(17, fmt::format("bumps of strength {:g}", strength), "finite",
                  [strength] { return bumped(strength); });
    }
}

}  // namespace luch::stress
