#include "framework/stress/made/everything.h"

#include "framework/stress/made/meshes.h"
#include "framework/stress/made/scenes.h"

namespace luch::stress {

NodeId add(Scene& scene, Geometry geometry, Material material, const Transform& to_world) {
    scene.geometries.push_back(std::move(geometry));
    scene.materials.push_back(std::move(material));
    return add_node(scene, "node", static_cast<GeometryId>(scene.geometries.size() - 1),
                    static_cast<MaterialId>(scene.materials.size() - 1), to_world);
}

namespace {

/// A cube less a ball, a mesh and the ground: a solid with parts of every kind, and the ground by
/// itself.
void add_solid_and_field(Scene& scene) {
    Image<float> heights({9, 7});
    for (int i = 0; i < 63; ++i) heights.pixels()[i] = static_cast<float>(i * 11 % 17) / 17;
    auto& geometries = scene.geometries;
    const auto first = static_cast<GeometryId>(geometries.size());
    geometries.emplace_back(Cube{.centre = {4, 1, 3}, .side = 6});
    geometries.emplace_back(Sphere{.centre = {1.5, 4, 0.5}, .radius = 2});
    geometries.emplace_back(uv_sphere(6, 9, 2.5));
    geometries.emplace_back(Heightfield(heights));
    geometries.emplace_back(Plane{.y = 3.5});
    using Operation = Csg::Operation;
    geometries.emplace_back(make_csg(Operation::join, first + 1, first + 2, geometries));
    geometries.emplace_back(make_csg(Operation::subtract, first, first + 5, geometries));
    geometries.emplace_back(make_csg(Operation::subtract, first + 6, first + 3, geometries));
    const Csg solid = make_csg(Operation::intersect, first + 7, first + 4, geometries);
    const Transform tilted = Transform::rotation(0.4, -0.3, 0.2);
    add(scene, solid, Phong{.texture = 2}, tilted.then(Transform::translation({-9, -1, 1})));
    scene.materials.emplace_back(Lambert{.texture = 0});
    const NodeId ground =
        add_node(scene, "ground", first + 3, static_cast<MaterialId>(scene.materials.size() - 1),
                 Transform::scaling({1, 2, 1}).then(Transform::translation({1, -2, -5})));
    scene.nodes[ground].bump = 1;
}

/// A block of layered glass.
void add_glass(Scene& scene) {
    scene.textures.emplace_back(Fresnel{.ior = 1.5});
    scene.textures.emplace_back(Bumps{.strength = 0.5});
    const auto bumps = static_cast<TextureId>(scene.textures.size() - 1);
    const auto glass = static_cast<MaterialId>(scene.materials.size());
    scene.materials.emplace_back(
        Refraction{.ior = 1.5, .inside_color = {0.2f, 0.9f, 0.5f}, .absorption = 0.4});
    scene.materials.emplace_back(Reflection{});
    scene.materials.emplace_back(Layered{{{glass, Rgb(1)}, {glass + 1, Rgb(0), bumps - 1}}});
    scene.geometries.emplace_back(Cube{.centre = {-2, 0, -5}, .side = 1.5});
    const NodeId block =
        add_node(scene, "glass", static_cast<GeometryId>(scene.geometries.size() - 1), glass + 2,
                 Transform::rotation(0.3, 0.1, 0));
    scene.nodes[block].moving = true;
    scene.nodes[1].bump = bumps;
}

void add_spot_and_sun(Scene& scene) {
    scene.lights.emplace_back(
        SpotLight{.position = {0, 9, -6}, .inner_cosine = 0.9, .outer_cosine = 0.6, .power = 60});
    scene.lights.emplace_back(
        DirectionalLight{.direction = glm::normalize(Vec3d(1, -2, 1)), .power = 0.4f});
}

}  // namespace

Scene bit_of_everything() {
    Scene scene = sixty_spheres();
    scene.settings.frame = {64, 48};
    scene.camera.position = {0, 2, -10};
    scene.textures.emplace_back(CheckerTexture{.scaling = 2});
    add(scene, Plane{.y = -3, .limit = 20}, Lambert{.texture = 0});
    add(scene, Plane{.y = -30}, Lambert{});
    scene.settings.background = Rgb(0.2f, 0.3f, 0.5f);
    Image<Rgb> heights({4, 4});
    for (int i = 0; i < 16; ++i) heights.pixels()[i] = Rgb(static_cast<float>(i * 7 % 16) / 16);
    scene.textures.emplace_back(BumpTexture{slopes_of(heights.view()), 2, 1});
    scene.textures.emplace_back(BitmapTexture{heights, 3});

    const Transform sheared{glm::dmat3(1, 0.5, 0, 0, 2, 0.3, 0, 0, 1), {-4, 3, 2}};
    const Transform mirrored =
        Transform::scaling({-1, 2, 0.5}).then(Transform::translation({4, 4, 1}));
    add(scene, uv_sphere(12, 16, 1), Phong{.color = {0.8f, 0.2f, 0.1f}, .exponent = 40}, sheared);
    add(scene, triangle_soup(200, 0.4, Key(7)), Lambert{.texture = 2}, mirrored);
    const NodeId cube = add(scene, Cube{.centre = {0, 1, -4}, .side = 2}, Lambert{.texture = 2},
                            Transform::rotation(0.5, 0.2, 0.1));
    scene.nodes[cube].bump = 1;
    const NodeId wall =
        add(scene, Plane{.y = 0, .limit = 6}, Reflection{},
            Transform::rotation(0.2, 1.4, 0).then(Transform::translation({0, 4, 14})));
    scene.nodes[wall].bump = 1;
    const auto lambert = static_cast<MaterialId>(scene.materials.size());
    scene.materials.emplace_back(Lambert{});
    scene.materials.emplace_back(Reflection{.glossiness = 0.8, .samples = 3});
    scene.materials.emplace_back(Layered{{{lambert, Rgb(1)}, {lambert + 1, Rgb(0.4f)}}});
    scene.geometries.emplace_back(Sphere{.centre = {2, 2, -6}, .radius = 1});
    add_node(scene, "layered", static_cast<GeometryId>(scene.geometries.size() - 1), lambert + 2,
             Transform());
    add(scene, Cube{.centre = {-5, 1, -5}, .side = 1}, Const{.color = {0.1f, 0.9f, 0.4f}});
    add_glass(scene);
    add_spot_and_sun(scene);
    add_solid_and_field(scene);
    const Transform lamp = Transform::scaling(Vec3d(3)).then(Transform::translation({0, 12, 0}));
    add_rect_light(scene, "lamp", RectLight{.to_world = lamp, .color = Rgb(1), .power = 80});
    return scene;
}

}  // namespace luch::stress
