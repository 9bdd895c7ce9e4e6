#include "framework/scene/census.h"

#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

TEST(Census, CountsNothingInAnEmptyScene) {
    Scene scene;
    const Census census = census_of(scene);
    EXPECT_EQ(census.nodes, 0u);
    EXPECT_EQ(census.lights(), 0u);
    EXPECT_EQ(census.lit + census.textured + census.mirrors + census.layered, 0u);
}

TEST(Census, CountsOnlyMaterialsThatNodesShow) {
    Scene scene = testing::empty_scene();
    scene.materials.emplace_back(Reflection{});
    scene.materials.emplace_back(Lambert{});
    const auto mirror = static_cast<MaterialId>(scene.materials.size() - 2), lambert = mirror + 1;
    EXPECT_EQ(census_of(scene).mirrors, 0u);
    const NodeId node =
        testing::add(scene, Sphere{}, Layered{{{mirror, Rgb(1)}, {lambert, Rgb(1)}}});
    EXPECT_EQ(census_of(scene).layered, 1u);
    EXPECT_EQ(census_of(scene).mirrors, 1u);
    EXPECT_EQ(census_of(scene).lit, 1u);
    scene.nodes[node].material = lambert;
    EXPECT_EQ(census_of(scene).layered, 0u);
    EXPECT_EQ(census_of(scene).mirrors, 0u);
}

TEST(Census, CountsMaterialsOfFiles) {
    Scene scene = testing::empty_scene();
    Mesh mesh = testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2});
    scene.materials.emplace_back(Refraction{});
    mesh.materials = {static_cast<MaterialId>(scene.materials.size() - 1)};
    const NodeId node = testing::add_shape(scene, mesh);
    EXPECT_EQ(census_of(scene).clear, 0u);
    scene.nodes[node].material = materials_of_file;
    EXPECT_EQ(census_of(scene).clear, 1u);
}

TEST(Census, DoesNotCountBlackMirrorsAndClearThings) {
    Scene scene = testing::empty_scene();
    testing::add(scene, Sphere{}, Reflection{.multiplier = Rgb(0)});
    testing::add(scene, Sphere{}, Refraction{.multiplier = Rgb(0)});
    EXPECT_EQ(census_of(scene).mirrors + census_of(scene).clear, 0u);
}

TEST(Census, TellsWhatIsMovedAndSmooth) {
    Scene scene = testing::empty_scene();
    testing::add_shape(scene, Sphere{});
    EXPECT_EQ(census_of(scene).moved, 0u);
    testing::add_shape(scene, Sphere{}, Transform::translation({0, 1e-300, 0}));
    EXPECT_EQ(census_of(scene).moved, 1u);
    testing::add_shape(scene, Sphere{}, Transform::scaling({1, 1, 1 + 1e-15}));
    EXPECT_EQ(census_of(scene).moved, 2u);
    EXPECT_EQ(census_of(scene).smooth, 0u);
    Mesh mesh = testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2});
    mesh.faceted = false;
    mesh.normals = {{0, 0, 1}};
    mesh.triangles[0].normal = {0, 0, 0};
    testing::add_shape(scene, mesh);
    EXPECT_EQ(census_of(scene).smooth, 1u);
    mesh.faceted = true;
    testing::add_shape(scene, mesh);
    EXPECT_EQ(census_of(scene).smooth, 1u);
    // A smooth part makes a solid smooth.
    mesh.faceted = false;
    scene.geometries.emplace_back(mesh);
    const auto part = static_cast<GeometryId>(scene.geometries.size() - 1);
    scene.geometries.emplace_back(Sphere{});
    testing::add_shape(scene, make_csg(Csg::Operation::join, part, part + 1, scene.geometries));
    EXPECT_EQ(census_of(scene).smooth, 2u);
    EXPECT_EQ(census_of(scene).solids, 1u);
}

TEST(Census, TellsLightsByWhereTheyShineFrom) {
    Scene scene = testing::empty_scene();
    scene.lights = {PointLight{}, SpotLight{}, RectLight{}, DirectionalLight{}, DirectionalLight{}};
    const Census census = census_of(scene);
    EXPECT_EQ(census.standing_lights, 2u);
    EXPECT_EQ(census.area_lights, 1u);
    EXPECT_EQ(census.distant_lights, 2u);
    EXPECT_EQ(census.lights(), 5u);
}

}  // namespace
}  // namespace luch
