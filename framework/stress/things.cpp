#include "framework/stress/things.h"

#include "framework/stress/made/everything.h"
#include "framework/stress/made/meshes.h"

namespace luch::stress {
namespace {

/// A grid of 8 × 8 cells, brought to −1…1.
Transform hills_to_world() {
    return Transform::scaling({0.25, 0.5, 0.25}).then(Transform::translation({-1, -0.5, -1}));
}

Heightfield hills() {
    Image<float> heights({8, 8});
    for (int i = 0; i < 64; ++i) heights.pixels()[i] = static_cast<float>(i * 7 % 16) / 16;
    return Heightfield(heights);
}

/// A cube less a ball at its corner.
void add_solid(Scene& scene, const Material& material, const Transform& to_world) {
    scene.geometries.emplace_back(Cube{.centre = {0, 0, 0}, .side = 1.5});
    scene.geometries.emplace_back(Sphere{.centre = {0.75, 0.75, -0.75}, .radius = 0.5});
    const auto last = static_cast<GeometryId>(scene.geometries.size() - 1);
    add(scene, make_csg(Csg::Operation::subtract, last - 1, last, scene.geometries), material,
        to_world);
}

}  // namespace

std::string_view to_string(Thing thing) {
    switch (thing) {
        case Thing::sphere:
            return "a sphere";
        case Thing::cube:
            return "a cube";
        case Thing::ball:
            return "a mesh";
        case Thing::solid:
            return "a solid";
        case Thing::hills:
            return "a heightfield";
        case Thing::square:
            break;
    }
    return "a square";
}

void add(Scene& scene, Thing thing, const Material& material, const Transform& to_world) {
    switch (thing) {
        case Thing::sphere:
            add(scene, Sphere{}, material, to_world);
            break;
        case Thing::cube:
            add(scene, Cube{.centre = {0, 0, 0}, .side = 1.5}, material, to_world);
            break;
        case Thing::ball:
            add(scene, uv_sphere(12, 16, 1), material, to_world);
            break;
        case Thing::solid:
            add_solid(scene, material, to_world);
            break;
        case Thing::hills:
            add(scene, hills(), material, hills_to_world().then(to_world));
            break;
        case Thing::square:
            add(scene, Plane{.y = 0, .limit = 1}, material, to_world);
            break;
    }
}

Scene one_thing(Thing thing, double scale, const Vec3d& by) {
    Scene scene;
    scene.settings = {.frame = {48, 36}, .ambient_light = Rgb(0), .background = Rgb(0.25f)};
    scene.settings.anti_aliasing = false;
    scene.camera.position = scale * Vec3d(0.25, 1, -3) + by;
    scene.camera.pitch_deg = -15;
    scene.camera.fov_deg = 60;
    scene.lights.emplace_back(PointLight{.position = scale * Vec3d(2, 3, -4) + by,
                                         .power = static_cast<float>(40 * scale * scale)});
    add(scene, thing, Lambert{.color = {0.75f, 0.5f, 0.25f}},
        Transform::rotation(0.5, 0.25, 0.125)
            .then(Transform::scaling(Vec3d(scale)))
            .then(Transform::translation(by)));
    return scene;
}

}  // namespace luch::stress
