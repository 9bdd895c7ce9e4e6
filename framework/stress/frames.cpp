#include "framework/stress/made/everything.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/subject.h"
#include "framework/stress/things.h"

#include <fmt/format.h>

namespace luch::stress {
namespace {

const Rgb sky(0.25f, 0.5f, 0.75f);

Scene under_sky() {
    Scene scene = empty_scene();
    scene.settings.frame = {48, 36};
    scene.settings.background = sky;
    return scene;
}

Scene with_mesh(Mesh mesh) {
    Scene scene = under_sky();
    add(scene, std::move(mesh), Lambert{}, Transform::translation({0, 0, 3}));
    return scene;
}

/// A triangle whose corners are one and the same point.
Mesh point_mesh() {
    Mesh mesh;
    set_positions(mesh, {Vec3d(0, 0, 0)});
    mesh.triangles.push_back({.position = {0, 0, 0}, .normal = {}, .uv = {}});
    return mesh;
}

/// A triangle that covers the whole frame, in one colour.
Scene covering_triangle() {
    Scene scene = under_sky();
    add(scene, triangle({-50, -50, 4}, {50, -50, 4}, {0, 90, 4}), Const{.color = sky / 2.0f});
    return scene;
}

/// The light of one lamp, from `count` of them in one place.
Scene lamps_in_one_place(int count) {
    Scene scene = one_thing(Thing::sphere);
    PointLight lamp = std::get<PointLight>(scene.lights[0]);
    lamp.power /= static_cast<float>(count);
    scene.lights.assign(static_cast<std::size_t>(count), lamp);
    return scene;
}

/// Lamps all over the place, one of them on a surface.
Scene lamps_everywhere(int count) {
    Scene scene = bit_of_everything();
    scene.settings.frame = {24, 18};
    for (int i = 0; i < count; ++i) {
        const Vec3d place = 8.0 * random_point(Key(71).branch(i), 1) + Vec3d(0, 2, 0);
        scene.lights.emplace_back(PointLight{.position = place, .power = 0.1f});
    }
    return scene;
}

/// No light of any kind: what is seen is black, or the sky.
Scene unlit() {
    Scene scene = one_thing(Thing::cube);
    scene.lights.clear();
    scene.camera.position = {0, 0, -0.5};
    scene.camera.pitch_deg = 0;
    scene.settings.background = Rgb(0);
    return scene;
}

/// A lamp exactly on a surface, where the distance is 0.
Scene lamp_on_surface() {
    Scene scene = one_thing(Thing::cube);
    scene.nodes.clear();
    add(scene, Thing::cube, Lambert{});
    std::get<PointLight>(scene.lights[0]).position = {0, 0, -0.75};
    return scene;
}

Scene sized(Size size) {
    Scene scene = bit_of_everything();
    scene.settings.frame = size;
    return scene;
}

StressResult same_on_threads(const Subject& subject, const Scene& scene, int spp) {
    const auto accelerator = build_accelerator(scene);
    Shot shot = shot_of(scene);
    shot.spp = spp;
    std::optional<Outcome> first;
    for (const int threads : {1, 2, 16}) {
        const Workers workers(threads);
        Outcome outcome = run(*subject.info->create(), {scene, *accelerator, workers}, shot, {},
                              {.warm_up = 0, .frames = 1});
        if (!outcome.plan.applies) return {StressVerdict::does_not_apply, outcome.plan.why};
        if (!first) {
            first = std::move(outcome);
        } else if (outcome.frame.colour != first->frame.colour) {
            return judged(false, fmt::format("another picture on {} threads", threads));
        } else if (outcome.counts.rays != first->counts.rays) {
            return judged(false, fmt::format("other rays on {} threads", threads));
        }
    }
    return finished(*first, judged(true, "the same bits on 1, 2 and 16 threads"));
}

Scene with_camera(Projection projection) {
    Scene scene = bit_of_everything();
    scene.camera.projection = projection;
    scene.camera.fov_deg = 180;
    scene.camera.width = 20;
    return scene;
}

Scene through_lens() {
    Scene scene = bit_of_everything();
    scene.camera.depth_of_field = true;
    scene.camera.lens_samples = 4;
    scene.settings.paths = 4;
    scene.camera.focal_distance = 8;
    return scene;
}

Scene with_two_eyes() {
    Scene scene = bit_of_everything();
    scene.camera.stereo_separation = 0.5;
    return scene;
}

Scene smoothed() {
    Scene scene = bit_of_everything();
    scene.settings.anti_aliasing = true;
    scene.settings.paths = 4;
    return scene;
}

}  // namespace

void add_frames_and_lights(CaseList& list) {
    list.look(12, "an empty scene", "the sky", under_sky, all_of(sky));
    list.look(
        12, "an empty mesh", "the sky", [] { return with_mesh({}); }, all_of(sky));
    list.look(
        12, "a mesh of one point", "the sky", [] { return with_mesh(point_mesh()); }, all_of(sky));
    list.look(
        12, "a sphere of radius 1e-30", "the sky",
        [] {
            Scene scene = under_sky();
            add(scene, Sphere{.centre = {0.1, 0.2, 3}, .radius = 1e-30}, Lambert{});
            return scene;
        },
        all_of(sky));
    list.look(12, "one triangle over the whole frame", "its colour", covering_triangle,
              all_of(sky / 2.0f));
    list.look(12, "one triangle", "finite", [] { return one_triangle(); });
    for (const Size size : {Size{1, 1}, Size{1, 37}, Size{37, 1}, Size{641, 7}, Size{17, 16}}) {
        list.look(12, fmt::format("a frame of {} × {}", size.width, size.height), "finite",
                  [size] { return sized(size); });
    }
    list.look(12, "no light at all", "black", unlit, all_of(Rgb(0)));
    list.look(
        12, "a thousand lamps in one place", "as one lamp of their power",
        [] { return lamps_in_one_place(1000); },
        if_approximates(as_of([] { return lamps_in_one_place(1); }, 0)));
    list.look(12, "a thousand lamps everywhere", "finite", [] { return lamps_everywhere(1000); });
    list.look(12, "a lamp exactly on a surface", "finite", lamp_on_surface);
}

void add_threads(CaseList& list) {
    const auto add = [&](std::string name, Scene (*scene)(), int spp) {
        list.add(21, std::move(name), "the same bits on 1, 2, 16 threads",
                 [subject = list.subject, scene, spp] {
                     return same_on_threads(subject, scene(), spp);
                 });
    };
    const int spp = list.subject.spp();
    add("a bit of everything", bit_of_everything, spp);
    add("sixty spheres", sixty_spheres, spp);
    add("the scene's own samples", smoothed, 0);
    add("two eyes", with_two_eyes, spp);
    add("a lens", through_lens, 0);
    add(
        "a fisheye", [] { return with_camera(Projection::fisheye); }, spp);
    add(
        "parallel rays", [] { return with_camera(Projection::orthographic); }, spp);
    add(
        "a sphere of a picture", [] { return with_camera(Projection::spherical); }, spp);
}

}  // namespace luch::stress
