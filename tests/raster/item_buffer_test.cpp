#include "framework/raster/item_buffer.h"

#include "framework/stress/raster/sights.h"
#include "tests/testing/everything.h"
#include "tests/testing/meshes.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

using stress::compared_with_brute;
using stress::Sights;

/// Spheres of triangles, sheared, mirrored and scaled, that hide one another.
Scene crowd() {
    Scene scene = testing::empty_scene();
    scene.geometries.emplace_back(testing::uv_sphere(12, 16, 1));
    scene.materials.emplace_back(Lambert{});
    for (int i = 0; i < 12; ++i) {
        Transform place = Transform::scaling({0.5 + 0.2 * i, i % 3 == 0 ? -1.0 : 1.0, 1});
        place = place.then(Transform::rotation(0.3 * i, 0.7 * i, 0));
        if (i % 4 == 1) place.matrix[1][0] += 0.5;
        place = place.then(Transform::translation({1.5 * (i % 4) - 2, 1.2 * (i % 3) - 1, 4.0 + i}));
        add_node(scene, "ball", 0, 0, place);
    }
    return scene;
}

TEST(ItemBuffer, ShowsInstancesWithAnyTransformAtEveryLevel) {
    for (const Isa isa : usable_isas()) {
        const Sights sights = compared_with_brute(crowd(), {48, 36}, isa);
        EXPECT_TRUE(sights.right()) << to_string(isa);
        EXPECT_GT(sights.hits, 400u);
        EXPECT_LT(sights.ambiguous, 30u);
    }
}

TEST(ItemBuffer, ShowsTransformsOfAnyScale) {
    for (const double scale : {1e-8, 1e-3, 1e3, 1e8}) {
        Scene scene = testing::empty_scene();
        testing::add_shape(
            scene, testing::uv_sphere(12, 16, 1),
            Transform::scaling(Vec3d(scale)).then(Transform::translation({0, 0, 3 * scale})));
        const Sights sights = compared_with_brute(scene, {64, 48}, usable_isas().back());
        EXPECT_TRUE(sights.right()) << scale;
        EXPECT_GT(sights.hits, 150u) << scale;
        EXPECT_LT(sights.ambiguous, 60u) << scale;
    }
}

TEST(ItemBuffer, ShowsWallsThatStandBeforeWhatWasDrawnFirst) {
    // A ramp that begins nearer than all walls, so it is drawn first, and walls before its far end.
    const Mesh ramp = testing::mesh_of({{-100, -1, 1}, {100, -1, 1}, {0, 60, 60}}, {0, 1, 2});
    std::vector<Vec3d> points;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 40; ++i) {
        const double slope = 0.02 * i - 0.1, z = 0.85 * 2.034 / (1.034 - slope);
        const double x = (0.1 * (i % 9) - 0.4) * z, y = slope * z, half = 0.12 * z;
        points.insert(points.end(), {{x - half, y, z}, {x, y + half, z}, {x + half, y, z}});
        indices.insert(indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    }
    Scene scene = testing::empty_scene();
    testing::add_shape(scene, ramp);
    testing::add_shape(scene, testing::mesh_of(points, indices));
    const Screen screen(scene.camera, {64, 48});
    const auto accelerator = build_accelerator(scene);
    WorkCounts work;
    ItemBuffer buffer(scene);
    buffer.draw(screen, Vec2d(0.5), Workers(1));  // with depths, nothing is skipped as hidden
    int wrong = 0, walls = 0;
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            const Item item = buffer.item(x, y);
            const Hit hit = accelerator->closest(screen.ray(x + 0.5, y + 0.5), work);
            if (item.ambiguous) continue;
            wrong += item.node == hit.node && (!hit || item.triangle == hit.primitive) ? 0 : 1;
            walls += hit.node == 1 ? 1 : 0;
        }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(walls, 300);
}

TEST(ItemBuffer, LeavesTiesToTheRay) {
    Scene scene = testing::empty_scene();
    const Mesh mesh = testing::triangle({-1, -1, 3}, {0, 1, 3}, {1, -1, 3});
    Mesh twice = mesh;
    twice.triangles.push_back(mesh.triangles[0]);
    testing::add_shape(scene, twice);
    const Sights sights = compared_with_brute(scene, {32, 24}, usable_isas().back());
    EXPECT_TRUE(sights.right());
    EXPECT_GT(sights.hits, 20u);
    EXPECT_GE(sights.ambiguous, sights.hits);
}

TEST(ItemBuffer, LeavesOutBackfacesThatAreCulled) {
    for (const bool cull : {false, true}) {
        Scene scene = testing::empty_scene();
        Mesh mesh = testing::uv_sphere(9, 12, 3);
        mesh.cull_backfaces = cull;
        testing::add_shape(scene, mesh, Transform::translation({0, 0, 1}));
        for (std::uint32_t i = 0; i < mesh.triangles.size(); i += 2) {
            std::swap(mesh.triangles[i].position[0], mesh.triangles[i].position[1]);
        }
        testing::add_shape(scene, mesh, Transform::translation({0.1, 0, 0.2}));
        const Sights sights = compared_with_brute(scene, {64, 48}, usable_isas().back());
        EXPECT_TRUE(sights.right()) << cull;
        EXPECT_GT(sights.hits, 1'000u) << cull;
        EXPECT_LT(sights.ambiguous, 40u) << cull;
    }
}

TEST(ItemBuffer, IsTheSameForOneTwoAndSixteenThreadsAndAnyInstructions) {
    const Scene scene = crowd();
    const Size size{201, 150};
    const Screen screen(scene.camera, size);
    ItemBuffer plain(scene, Isa::plain);
    plain.draw(screen, Vec2d(0.5), Workers(1), true);
    EXPECT_LT(plain.ambiguous_count(), 300u);
    for (const Isa isa : usable_isas()) {
        ItemBuffer other(scene, isa);
        for (const int threads : {1, 2, 16}) {
            other.draw(screen, Vec2d(0.5), Workers(threads), true);
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    ASSERT_EQ(other.item(x, y), plain.item(x, y)) << x << ' ' << y;
                    ASSERT_EQ(other.depths(x, y).nearest, plain.depths(x, y).nearest);
                    ASSERT_EQ(other.depths(x, y).second, plain.depths(x, y).second);
                }
            }
        }
    }
}

TEST(ItemBuffer, ShowsNothingOfAnEmptySceneOrAnEmptyMesh) {
    Scene scene = testing::empty_scene();
    EXPECT_EQ(compared_with_brute(scene, {20, 10}, Isa::plain).ambiguous, 0u);
    testing::add_shape(scene, Mesh{});
    const Sights sights = compared_with_brute(scene, {20, 10}, Isa::plain);
    EXPECT_TRUE(sights.right());
    EXPECT_EQ(sights.pixels, 200u);
    EXPECT_EQ(sights.hits + sights.ambiguous, 0u);
}

TEST(ItemBuffer, TakesFramesOfAnyShapeAndAnyPointOfAPixel) {
    const Scene scene = crowd();
    const auto accelerator = build_accelerator(scene);
    WorkCounts work;
    ItemBuffer buffer(scene);
    for (const Size size : {Size{1, 1}, Size{1, 37}, Size{641, 7}, Size{65, 64}}) {
        for (const Vec2d& offset : {Vec2d(0.5), Vec2d(0.125, 0.875)}) {
            const Sights sights =
                stress::compared(buffer, scene.camera, size, offset, Workers(2),
                                 [&](const Ray& ray) { return accelerator->closest(ray, work); });
            EXPECT_TRUE(sights.right()) << size.width;
            EXPECT_EQ(sights.pixels, size.area());
        }
    }
}

TEST(ItemBuffer, MarksWhereShapesMayBeInFrontAndOnlyThere) {
    Scene scene = testing::empty_scene();
    testing::add_shape(scene, testing::uv_sphere(12, 16, 2), Transform::translation({0, 0, 6}));
    testing::add_shape(scene, Sphere{{-1.2, 0, 3}, 0.5});  // in front of it
    testing::add_shape(scene, Sphere{{0, 0, 12}, 1});      // behind it
    const Sights sights = compared_with_brute(scene, {64, 48}, usable_isas().back());
    EXPECT_TRUE(sights.right());
    EXPECT_GT(sights.ambiguous, 50u);
    EXPECT_LT(sights.ambiguous, 400u);
}

TEST(ItemBuffer, AppliesToPinholeCamerasOnly) {
    Camera camera;
    EXPECT_TRUE(ItemBuffer::applies(camera, {640, 480}));
    EXPECT_FALSE(ItemBuffer::applies(camera, {20'000, 4}));
    camera.depth_of_field = true;
    EXPECT_FALSE(ItemBuffer::applies(camera, {640, 480}));
    camera = {};
    for (const Projection other :
         {Projection::fisheye, Projection::spherical, Projection::orthographic}) {
        camera.projection = other;
        EXPECT_FALSE(ItemBuffer::applies(camera, {640, 480}));
    }
}

/// Compares what a tile and its pixels are said to show; counts ambiguous pixels and items.
std::pair<int, int> compared(const ItemBuffer& buffer, int index) {
    ItemPacket packet;
    buffer.show(index, packet);
    const Tile tile = buffer.tile(index);
    std::pair<int, int> counts;
    for (int k = 0; k < RayPacket::capacity; ++k) {
        const int x = tile.x0 + ItemBuffer::x_in_tile(k), y = tile.y0 + ItemBuffer::y_in_tile(k);
        if (x >= tile.x1 || y >= tile.y1) continue;
        const Item item = buffer.item(x, y);
        EXPECT_EQ(packet.ambiguous[k], item.ambiguous);
        EXPECT_EQ(packet.node[k], item.node);
        EXPECT_EQ(packet.depths[k].nearest, buffer.depths(x, y).nearest);
        EXPECT_EQ(packet.depths[k].second, buffer.depths(x, y).second);
        counts.first += item.ambiguous;
        counts.second += item.node != no_node;
    }
    return counts;
}

TEST(ItemBuffer, ShowsATileAsItShowsItsPixels) {
    Scene scene = testing::empty_scene();
    const Mesh ball = testing::uv_sphere(9, 8, 1);
    for (const double x : {-2.0, -0.5}) {  // a tile sees both
        testing::add_shape(scene, ball, Transform::translation({x, 0, 4}));
    }
    testing::add_shape(scene, Cube{.centre = {0, 2, 4}});
    ItemBuffer buffer(scene);
    buffer.draw(Screen(scene.camera, {70, 50}), Vec2d(0.5), Workers(1), true);
    int ambiguous = 0, shown = 0;
    for (int i = 0; i < buffer.tile_count(); ++i) {
        const auto [doubtful, items] = compared(buffer, i);
        ambiguous += doubtful;
        shown += items;
    }
    EXPECT_GT(ambiguous, 20);
    EXPECT_GT(shown, 100);
}

TEST(ItemBuffer, LeavesNodesWithoutAMeshToTheCallerWhenAsked) {
    const Scene scene = testing::one_of_each();
    Scene meshes = scene;
    std::erase_if(meshes.nodes, [&](const Node& node) {
        return !std::holds_alternative<Mesh>(scene.geometries[node.geometry]);
    });
    ItemBuffer ignoring(scene, parsed_isa(""), ItemBuffer::Others::ignore), alone(meshes);
    const Screen screen(scene.camera, {160, 120});
    for (ItemBuffer* buffer : {&ignoring, &alone}) buffer->draw(screen, Vec2d(0.5), Workers(1));
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 160; ++x) {
            const Item a = ignoring.item(x, y), b = alone.item(x, y);
            EXPECT_EQ(a.ambiguous, b.ambiguous);
            EXPECT_EQ(a.node == no_node, b.node == no_node);
            EXPECT_EQ(a.triangle, b.triangle);
        }
    }
    EXPECT_LT(ignoring.ambiguous_count(), 20u);
}

}  // namespace
}  // namespace luch
