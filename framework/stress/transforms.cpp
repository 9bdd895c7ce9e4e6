#include "framework/stress/made/everything.h"
#include "framework/stress/made/meshes.h"
#include "framework/stress/subject.h"
#include "framework/stress/things.h"

#include <fmt/format.h>

namespace luch::stress {
namespace {

/// The share of pixels where a rim may fall to the other side of a pixel's centre.
constexpr double rims = 0.01;
// No float is one of them, and no sum with a detail is exact in double.
const Vec3d far_away(1'000'000.1, -2'000'000.3, 3'000'000.7);

/// A sphere or a cube whose own numbers say where it stands; the node's transform says nothing.
Scene placed_by_itself(bool sphere, const Vec3d& by) {
    Scene scene = one_thing(Thing::sphere, 1e-3, by);
    scene.nodes.clear();
    const Lambert material{.color = {0.75f, 0.5f, 0.25f}};
    if (sphere) {
        add(scene, Sphere{.centre = by, .radius = 1e-3}, material);
    } else {
        add(scene, Cube{.centre = by, .side = 1.5e-3}, material);
    }
    return scene;
}

/// Details of a thousandth on a floor that they throw shadows on.
Scene details(const Vec3d& by) {
    constexpr double scale = 1e-3;
    Scene scene = one_thing(Thing::ball, scale, by);
    scene.camera.fov_deg = 90;
    double x = -2.25;
    for (const Thing thing : all_things) {
        add(scene, thing, Lambert{.color = {0.25f, 0.5f, 0.75f}},
            Transform::scaling(Vec3d(0.3 * scale))
                .then(Transform::translation(scale * Vec3d(x, -0.5, 0.5) + by)));
        x += 0.9;
    }
    add(scene, Plane{.y = 0, .limit = 6 * scale}, Lambert{},
        Transform::translation(scale * Vec3d(0, -1, 0) + by));
    return scene;
}

/// The ball, every corner moved by the matrix before it is stored, or by its node.
Scene sheared(bool by_node) {
    const Transform shear{glm::dmat3(1, 0.75, 0, 0, 1.5, 0.25, 0, 0, 1), Vec3d(0)};
    Scene scene = one_thing(Thing::ball);
    scene.nodes.clear();
    const Lambert material{.color = {0.75f, 0.5f, 0.25f}};
    if (by_node) {
        add(scene, uv_sphere(12, 16, 1), material, shear);
        return scene;
    }
    const Mesh round = uv_sphere(12, 16, 1);
    std::vector<Vec3d> positions;
    for (const Vec3& position : round.positions) {
        positions.push_back(shear.point(round.from_frame.point(Vec3d(position))));
    }
    Mesh mesh;
    mesh.triangles = round.triangles;
    set_positions(mesh, positions);
    add(scene, mesh, material);
    return scene;
}

Scene unturned(Thing thing) {
    Scene scene = one_thing(thing);
    scene.nodes.clear();
    add(scene, thing, Lambert{.color = {0.75f, 0.5f, 0.25f}},
        Transform::rotation(0.5, 0.25, 0.125));
    return scene;
}

/// As seen in a mirror at x = 0.
Scene mirrored(Thing thing) {
    Scene scene = unturned(thing);
    const Transform flip = Transform::scaling({-1, 1, 1});
    Node& node = scene.nodes[0];
    node.to_world = node.to_world.then(flip);
    node.to_object = node.to_world.inverse();
    scene.camera.position.x *= -1;
    std::get<PointLight>(scene.lights[0]).position.x *= -1;
    return scene;
}

StressResult is_flipped(const Sight& sight, Thing thing) {
    const Outcome truth = picture(sight.subject, unturned(thing), sight.shot.spp);
    Image<Rgb> flipped(sight.shot.size);
    for (int y = 0; y < flipped.height(); ++y) {
        for (int x = 0; x < flipped.width(); ++x) {
            flipped(x, y) = truth.frame.colour(flipped.width() - 1 - x, y);
        }
    }
    const std::size_t off =
        unlike(flipped.view(), sight.colour(), 1e-4, sight.subject.info->resolution);
    const auto count = static_cast<double>(sight.shot.size.area());
    return judged(static_cast<double>(off) <= rims * count,
                  fmt::format("{} of {} pixels differ", off, count));
}

/// Scaled by less than a millionth along one axis only, so the thing is next to flat.
Scene flattened(Thing thing) {
    Scene scene = one_thing(thing);
    scene.nodes.clear();
    add(scene, thing, Lambert{},
        Transform::scaling({1, 1e-8, 1}).then(Transform::rotation(0.3, 0.2, 0.1)));
    return scene;
}

}  // namespace

void add_small_and_far(CaseList& list) {
    for (const Thing thing : all_things) {
        list.look(
            8, fmt::format("{} of 1e-3, moved by 1e6", to_string(thing)), "the same picture",
            [thing] { return one_thing(thing, 1e-3, far_away); },
            as_of([thing] { return one_thing(thing, 1e-3); }, rims));
    }
    for (const bool sphere : {true, false}) {
        list.look(
            8, fmt::format("{} of 1e-3, at 1e6 by its own numbers", sphere ? "a sphere" : "a cube"),
            "the same picture", [sphere] { return placed_by_itself(sphere, far_away); },
            as_of([sphere] { return placed_by_itself(sphere, Vec3d(0)); }, rims));
    }
    list.look(
        8, "many details of 1e-3, moved by 1e6", "the same picture",
        [] { return details(far_away); }, as_of([] { return details(Vec3d(0)); }, 2 * rims));
}

void add_transforms(CaseList& list) {
    for (const Thing thing : all_things) {
        const std::string name(to_string(thing));
        for (const double scale : {1e-8, 1e8}) {
            list.look(
                11, fmt::format("{} in a world scaled by {:g}", name, scale), "the same picture",
                [thing, scale] { return one_thing(thing, scale); },
                as_of([thing] { return one_thing(thing); }, rims));
        }
        list.look(
            11, fmt::format("{}, mirrored", name), "the mirrored picture",
            [thing] { return mirrored(thing); },
            if_approximates([thing](const Sight& sight) { return is_flipped(sight, thing); }));
        list.look(11, fmt::format("{}, scaled by 1e-8 along one axis", name), "finite",
                  [thing] { return flattened(thing); });
    }
    list.look(
        11, "a mesh, sheared by its node", "as sheared by itself", [] { return sheared(true); },
        as_of([] { return sheared(false); }, rims));
}

}  // namespace luch::stress
