#include "framework/trace/whitted.h"

#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

/// A floor at y = 0 with a light 2 above it, and nothing else; no ambient light.
Scene lit_floor(const Material& material) {
    Scene scene = testing::empty_scene();
    scene.lights.clear();
    scene.settings.ambient_light = Rgb(0);
    scene.lights.emplace_back(
        PointLight{.position = {0, 2, 0}, .color = {1, 0.5f, 0.25f}, .power = 8});
    testing::add(scene, Plane{}, material);
    return scene;
}

struct Result {
    Rgb colour;
    Counts counts;
};

Result seen(const Scene& scene, const Ray& ray,
            const Needs& needs = Needs().without(Part::dark_shadow_rays)) {
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    const Rgb colour = Whitted(scene, needs, tracer).radiance(RayKind::primary, ray, Key(1));
    return {colour, tracer.counts()};
}

void expect_near(const Rgb& a, const Rgb& b, float tolerance = 1e-5f) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << "channel " << k;
}

const Ray down_at_origin{{-1, 1, 0}, glm::normalize(Vec3d(1, -1, 0))};

TEST(Whitted, LightsLambertByTheInverseSquareOfDistance) {
    const auto [colour, counts] = seen(lit_floor(Lambert{.color = Rgb(0.5f)}), down_at_origin);
    expect_near(colour, Rgb(1, 0.5f, 0.25f));  // 0.5 · 8/2²
    EXPECT_EQ(counts.of(RayKind::shadow), 1u);
    EXPECT_EQ(counts.shades, 1u);
}

TEST(Whitted, WeighsLightByTheCosineAtTheSurface) {
    const Ray aside{{std::sqrt(12.0), 1, 0},
                    {0, -1, 0}};  // the light is 4 away, 60° from the normal
    expect_near(seen(lit_floor(Lambert{.color = Rgb(1)}), aside).colour,
                Rgb(1, 0.5f, 0.25f) * (8.0f / 16 * 0.5f));
}

TEST(Whitted, AddsPhongsHighlightWithoutPowerOrDistance) {
    const Scene scene = lit_floor(Phong{.color = Rgb(0), .specular = Rgb(0.5f), .exponent = 2});
    // Seen at 45° with the light at the zenith: cos γ = cos 45°.
    expect_near(seen(scene, down_at_origin).colour, Rgb(1, 0.5f, 0.25f) * (0.5f * 0.5f));
}

TEST(Whitted, PutsAShadowWhereTheLightIsBlocked) {
    Scene scene = lit_floor(Lambert{});
    testing::add(scene, Sphere{.centre = {0, 1, 0}, .radius = 0.3}, Const{});
    expect_near(seen(scene, down_at_origin).colour, Rgb(0));
}

TEST(Whitted, TakesNoLightFromBehindASurface) {
    Scene scene = lit_floor(Lambert{});
    std::get<PointLight>(scene.lights[0]).position.y = -2;
    expect_near(seen(scene, down_at_origin).colour, Rgb(0));
    EXPECT_EQ(seen(scene, down_at_origin).counts.of(RayKind::shadow), 0u);
    const Result forced = seen(scene, down_at_origin, {});
    expect_near(forced.colour, Rgb(0));
    EXPECT_EQ(forced.counts.of(RayKind::shadow), 1u);
}

TEST(Whitted, AddsAmbientLightEverywhere) {
    Scene scene = lit_floor(Lambert{.color = Rgb(0.5f)});
    scene.lights.clear();
    scene.settings.ambient_light = {0.2f, 0.4f, 0.6f};
    expect_near(seen(scene, down_at_origin).colour, {0.1f, 0.2f, 0.3f});
}

TEST(Whitted, MirrorsTheSky) {
    Scene scene = lit_floor(Reflection{.multiplier = {0.5f, 1, 1}});
    scene.settings.background = {0.4f, 0.5f, 0.6f};
    const auto [colour, counts] = seen(scene, down_at_origin);
    expect_near(colour, {0.2f, 0.5f, 0.6f});
    EXPECT_EQ(counts.of(RayKind::reflection), 1u);
    EXPECT_EQ(counts.of(RayKind::shadow), 0u);
}

TEST(Whitted, EndsBetweenTwoMirrorsAtTheDepthLimit) {
    Scene scene = lit_floor(Reflection{.multiplier = Rgb(1)});
    testing::add(scene, Plane{.y = 3}, Reflection{.multiplier = Rgb(1)});
    scene.settings.max_depth = 7;
    const auto [colour, counts] = seen(scene, {{0, 1, 0}, {0, -1, 0}});
    EXPECT_EQ(colour, Rgb(0));
    EXPECT_EQ(counts.of(RayKind::reflection), 7u);
}

TEST(Whitted, BlendsLayersOverOneAnother) {
    Scene scene = lit_floor(Const{.color = {1, 0, 0}});
    const auto red = static_cast<MaterialId>(scene.materials.size() - 1);
    scene.materials.emplace_back(Const{.color = {0, 1, 0}});
    scene.materials.emplace_back(Layered{{{red, Rgb(1)}, {red + 1, {0.25f, 0.25f, 0.25f}}}});
    scene.nodes.back().material = red + 2;
    expect_near(seen(scene, down_at_origin).colour, {0.75f, 0.25f, 0});
}

TEST(Whitted, ShowsEachTriangleInTheMaterialOfItsFile) {
    Scene scene = lit_floor(Const{.color = {1, 0, 0}});
    const auto red = static_cast<MaterialId>(scene.materials.size() - 1);
    scene.materials.emplace_back(Const{.color = {0, 1, 0}});
    Mesh mesh = testing::mesh_of({{-2, 1, -1}, {2, 1, -1}, {0, 1, 3}, {-2, 1, 9}, {2, 1, 9}},
                                 {0, 1, 2, 2, 3, 4});
    mesh.materials = {red + 1, red};
    testing::add_shape(scene, std::move(mesh));
    scene.nodes.back().material = materials_of_file;
    EXPECT_EQ(seen(scene, {{0, 2, 0}, {0, -1, 0}}).colour, Rgb(0, 1, 0));
    EXPECT_EQ(seen(scene, {{0, 2, 7}, {0, -1, 0}}).colour, Rgb(1, 0, 0));
}

TEST(Whitted, LightsWithARectLightOnItsLowerSideOnly) {
    Scene scene = lit_floor(Lambert{.color = Rgb(1)});
    scene.lights.clear();
    const Transform high = Transform::scaling(Vec3d(0.01)).then(Transform::translation({0, 2, 0}));
    add_rect_light(scene, "lamp", RectLight{.to_world = high, .color = Rgb(1), .power = 8});
    const Ray below{{-1, 1, 0}, glm::normalize(Vec3d(1, -1, 0))};
    expect_near(seen(scene, below).colour, Rgb(2), 1e-3f);  // small and far: as a point light
    // Its face shows colour·power/area from below and black from above.
    expect_near(seen(scene, {{0, 1, 0}, {0, 1, 0}}).colour, Rgb(8 / 1e-4f), 10);
    expect_near(seen(scene, {{0, 3, 0}, {0, -1, 0}}).colour, Rgb(0));
    testing::add(scene, Plane{.y = 4}, Lambert{.color = Rgb(1)});
    expect_near(seen(scene, {{0.5, 3, 0}, {0, 1, 0}}).colour, Rgb(0));  // above the lamp: dark
}

TEST(Whitted, IsNotShadowedByARectLightsOwnFaceHoweverItIsTurned) {
    for (int i = 0; i < 50; ++i) {
        const Key key = Key(3).branch(i);
        const auto turn = Transform::rotation(6 * key.uniform(0), key.uniform(1) - 0.5, 0);
        const Vec3d centre{key.uniform(2), 2, key.uniform(3)};
        Scene scene = lit_floor(Lambert{.color = Rgb(1)});
        scene.lights.clear();
        const RectLight light{
            .to_world =
                Transform::scaling(Vec3d(0.01)).then(turn).then(Transform::translation(centre)),
            .power = 8,
            .x_samples = 8,
            .y_samples = 8};
        add_rect_light(scene, "lamp", light);
        const double distance = glm::length(centre);
        const double at_light = glm::dot(turn.direction({0, -1, 0}), -centre) / distance;
        const double expected = 8 * at_light * (centre.y / distance) / (distance * distance);
        expect_near(seen(scene, down_at_origin).colour, Rgb(static_cast<float>(expected)), 0.01f);
    }
}

TEST(Whitted, GivesTheSamePictureWithEveryStageForcedOn) {
    const Scene scene = testing::bit_of_everything();
    const auto accelerator = build_accelerator(scene);
    Tracer planned(*accelerator), forced(*accelerator);
    const Screen screen(scene.camera, scene.settings.frame);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            const Ray ray = screen.ray(x + 0.5, y + 0.5);
            const Rgb a = Whitted(scene, Needs().without(Part::dark_shadow_rays), planned)
                              .radiance(RayKind::primary, ray, Key(x * y));
            const Rgb b = Whitted(scene, {}, forced).radiance(RayKind::primary, ray, Key(x * y));
            ASSERT_EQ(a, b) << x << " " << y;
        }
    }
    EXPECT_LT(planned.counts().of(RayKind::shadow), forced.counts().of(RayKind::shadow));
}

}  // namespace
}  // namespace luch
