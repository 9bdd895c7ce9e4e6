#include "framework/stress/made/scenes.h"

#include "framework/math/rng.h"

namespace luch::stress {

Scene empty_scene() {
    Scene scene;
    scene.settings.frame = {160, 120};
    scene.settings.anti_aliasing = false;
    PointLight light;
    light.position = {0, 10, -10};
    light.power = 200;
    scene.lights.emplace_back(light);
    return scene;
}

NodeId add_shape(Scene& scene, Geometry geometry, const Transform& to_world, const Rgb& colour) {
    scene.geometries.push_back(std::move(geometry));
    scene.materials.emplace_back(Lambert{.color = colour});
    return add_node(scene, "node" + std::to_string(scene.nodes.size()),
                    static_cast<GeometryId>(scene.geometries.size() - 1),
                    static_cast<MaterialId>(scene.materials.size() - 1), to_world);
}

Mesh mesh_of(const std::vector<Vec3d>& positions, const std::vector<std::uint32_t>& indices) {
    Mesh mesh;
    set_positions(mesh, positions);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        mesh.triangles.push_back({{indices[i], indices[i + 1], indices[i + 2]}, {}, {}});
    }
    mesh.faceted = true;
    return mesh;
}

Scene one_triangle() {
    Scene scene = empty_scene();
    add_shape(scene, mesh_of({{-1, -1, 4}, {1.5, -0.5, 6}, {0.25, 1, 5}}, {0, 1, 2}));
    return scene;
}

Scene sixty_spheres() {
    Scene scene = empty_scene();
    const Key key(60);
    for (int i = 0; i < 60; ++i) {
        const auto random = [&](std::uint64_t what) { return key.branch(i).uniform(what); };
        const double z = 6 + 14 * random(0);
        const Vec3d centre{(1.8 * random(1) - 0.9) * 0.8 * z, (1.8 * random(2) - 0.9) * 0.6 * z, z};
        const Rgb colour{random(3), random(4), random(5)};
        add_shape(scene, Sphere{.centre = centre, .radius = 0.6 + 1.2 * random(6)}, {}, colour);
    }
    return scene;
}

Scene one_of_each() {
    Scene scene = empty_scene();
    add_shape(scene, Plane{.y = -1.5}, {}, {0.6f, 0.6f, 0.3f});
    add_shape(scene, Plane{.limit = 1},
              Transform::rotation(0.3, 1.1, 0).then(Transform::translation({-2, 1, 7})),
              {0.2f, 0.7f, 0.3f});
    add_shape(scene, Cube{.centre = {1, 0, 0}, .side = 1.5},
              Transform::rotation(0.5, 0.2, 0.1).then(Transform::translation({1, 0, 6})),
              {0.8f, 0.3f, 0.2f});
    add_shape(scene, Sphere{.radius = 1.2},
              Transform::scaling({1, 0.8, 1}).then(Transform::translation({-1, -0.5, 5})),
              {0.2f, 0.3f, 0.9f});
    add_shape(scene,
              mesh_of({{0, 1, 4}, {1.5, 1, 4}, {0.5, 2, 5}, {0.7, 1.4, 3.5}},
                      {0, 1, 3, 1, 2, 3, 2, 0, 3}),
              {}, {0.7f, 0.2f, 0.7f});
    return scene;
}

OwnStudio::OwnStudio(Scene scene, int threads)
    : scene_(std::move(scene)), accelerator_(build_accelerator(scene_)), workers_(threads) {}

Outcome OwnStudio::render(Technique& technique, const Budget& budget) const {
    Shot shot = shot_of(scene_);
    shot.spp = 1;
    return render(technique, shot, budget);
}

Outcome OwnStudio::render(Technique& technique, const Shot& shot, const Budget& budget) const {
    return run(technique, studio(), shot, budget, {.warm_up = 0, .frames = 1});
}

std::size_t different_pixels(const Outcome& a, const Outcome& b) {
    const auto &left = a.frame.colour.pixels(), &right = b.frame.colour.pixels();
    if (left.size() != right.size()) return std::max(left.size(), right.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < left.size(); ++i) count += left[i] != right[i];
    return count;
}

}  // namespace luch::stress
