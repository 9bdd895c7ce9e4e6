#include "framework/math/rng.h"
#include "tests/raster/views.h"
#include "tests/testing/everything.h"
#include "tests/testing/meshes.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <bit>

// The rasteriser's row of extreme cases: exact items on meshes of every awkward sort.
namespace luch {
namespace {

using testing::camera_at;
using testing::random_point;
using testing::Sights;

Camera random_camera(Key key) {
    const double fov = key.bits(3) % 8 == 0 ? 150 : 20 + 80 * key.uniform(4);
    return camera_at(random_point(key.branch(0), 1), 360 * key.uniform(1),
                     180 * key.uniform(2) - 90, fov);
}

/// A patch of triangles that share their edges: a fan around a point ahead of the camera, as large
/// as `size`, its rim of random radii.
Mesh fan(const Camera& camera, double size, Key key) {
    const Transform to_world = camera.to_world();
    const int sides = 3 + static_cast<int>(key.bits(0) % 4);
    const double distance = std::exp2(6 * key.uniform(1) - 3);
    std::vector<Vec3d> points{to_world.point({0.3 * distance * (key.uniform(2) - 0.5),
                                              0.3 * distance * (key.uniform(3) - 0.5), distance})};
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * 3.14159265 * i / sides;
        const double radius = size * distance * (0.2 + key.uniform(10 + i));
        points.push_back(to_world.point({radius * std::cos(angle), radius * std::sin(angle),
                                         distance * (1 + 0.2 * size * key.uniform(30 + i))}));
        const auto next = static_cast<std::uint32_t>((i + 1) % sides);
        indices.insert(indices.end(), {0, static_cast<std::uint32_t>(i + 1), next + 1});
    }
    return testing::mesh_of(points, indices);
}

Sights seen(Mesh mesh, const Camera& camera, Size size, Isa isa) {
    Scene scene = testing::empty_scene();
    scene.camera = camera;
    testing::add_shape(scene, std::move(mesh));
    return testing::compared_with_brute(scene, size, isa);
}

class MeshStorm : public ::testing::TestWithParam<Isa> {};

TEST_P(MeshStorm, CoversSharedEdgesOnceOnAHundredThousandPatchesInAll) {
    Sights all;
    for (int i = 0; i < 25'000; ++i) {
        const Key key = Key(41).branch(i);
        const Camera camera = random_camera(key);
        all +=
            seen(fan(camera, i % 2 == 0 ? 0.5 : 0.05, key.branch(9)), camera, {8, 8}, GetParam());
        ASSERT_TRUE(all.right()) << "patch " << i;
    }
    EXPECT_GT(all.hits, 250'000u);
    EXPECT_LT(all.ambiguous, all.pixels / 200);
}

/// Soup with corners all around the eye, behind it and in the plane through it.
TEST_P(MeshStorm, IsExactForCornersBehindTheEyeAndInItsPlane) {
    Sights all;
    for (int i = 0; i < 150; ++i) {
        const Key key = Key(42).branch(i);
        Mesh mesh = testing::triangle_soup(40, i % 3 == 0 ? 2 : 0.7, key.branch(8));
        Camera camera = random_camera(key);
        if (i % 4 == 0) {  // w = 0 exactly for a corner: axes, and an eye at its height
            camera = camera_at(Vec3d(mesh.corner(0, 1)), 90.0 * (i % 16 / 4), 0, 90);
            camera.position.x = i % 8 == 0 ? camera.position.x : 0;
        }
        all += seen(mesh, camera, {24, 16}, GetParam());
        ASSERT_TRUE(all.right()) << "mesh " << i;
    }
    EXPECT_GT(all.hits, 30'000u);
    EXPECT_LT(all.ambiguous, all.pixels / 20);
}

/// Corners a millionth ahead of the eye's plane, or as far away as a frame can be wide.
TEST_P(MeshStorm, IsExactForCornersTenMillionPixelsOffTheFrame) {
    Sights near, far;
    for (int i = 0; i < 300; ++i) {
        const Key key = Key(43).branch(i);
        const Camera camera = random_camera(key);
        std::vector<Vec3d> points;
        for (int k = 0; k < 12; ++k) {
            Vec3d p = random_point(key.branch(20 + k), 2);
            if (i % 3 == 0) p *= k % 3 == 0 ? 1e6 : 1;
            if (i % 3 != 0) p.z = k % 3 == 0 ? 1e-6 : 2 + p.z;
            points.push_back(camera.to_world().point(p));
        }
        const Mesh mesh = testing::mesh_of(points, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
        const Sights sights = seen(mesh, camera, {24, 16}, GetParam());
        ASSERT_TRUE(sights.right()) << "mesh " << i;
        (i % 3 == 0 ? far : near) += sights;
    }
    EXPECT_GT(far.hits, 3'000u);
    EXPECT_GT(near.hits, 10'000u);
    EXPECT_LT(near.ambiguous, near.pixels / 20);
}

TEST_P(MeshStorm, IsExactForSlivers) {
    Sights all;
    for (int i = 0; i < 200; ++i) {
        const Key key = Key(44).branch(i);
        std::vector<Vec3d> points;
        std::vector<std::uint32_t> indices;
        const double width = std::exp2(-1 - 24 * key.uniform(5));
        for (std::uint32_t k = 0; k < 20; ++k) {
            const Vec3d a = random_point(key.branch(20 + k), 2),
                        b = random_point(key.branch(60 + k), 2);
            points.insert(points.end(), {a, b, a + width * (random_point(key.branch(90 + k), 1))});
            indices.insert(indices.end(), {3 * k, 3 * k + 1, 3 * k + 2});
        }
        all += seen(testing::mesh_of(points, indices), random_camera(key), {24, 16}, GetParam());
        ASSERT_TRUE(all.right()) << "mesh " << i;
    }
    EXPECT_GT(all.hits, 500u);
    EXPECT_LT(all.ambiguous, all.pixels / 20);
}

/// Triangles that lie in planes through the eye, and duplicates.
TEST_P(MeshStorm, IsExactForTrianglesSeenFromTheirEdge) {
    Sights all;
    for (int i = 0; i < 150; ++i) {
        const Key key = Key(45).branch(i);
        std::vector<Vec3d> points;
        std::vector<std::uint32_t> indices;
        for (std::uint32_t k = 0; k < 24; ++k) {
            Vec3d p = random_point(key.branch(20 + k), 2);
            if (i % 2 == 0) p[static_cast<int>(k / 3 % 3)] = 0.25;
            points.push_back(p);
            indices.push_back(k);
        }
        Camera camera =
            camera_at(Vec3d(0.25, 0.25, 0.25), 90.0 * (i % 4) + (i % 8 < 4 ? 0 : 17), 0, 90);
        all += seen(testing::mesh_of(points, indices), camera, {24, 16}, GetParam());
        ASSERT_TRUE(all.right()) << "mesh " << i;
    }
    EXPECT_GT(all.hits, 10'000u);
}

TEST_P(MeshStorm, IsExactForRandomBits) {
    Sights all;
    for (int i = 0; i < 100; ++i) {
        const Key key = Key(46).branch(i);
        Mesh mesh = testing::triangle_soup(30, 1, key.branch(8));
        for (std::uint32_t k = 0; k < 6; ++k) {
            Vec3& p = mesh.positions[key.bits(k) % mesh.positions.size()];
            p[static_cast<int>(k % 3)] =
                std::bit_cast<float>(static_cast<std::uint32_t>(key.bits(100 + k)));
        }
        for (int k = 0; k < 3; ++k) mesh.triangles[3].position[k] = mesh.triangles[3].position[0];
        all += seen(mesh, random_camera(key), {24, 16}, GetParam());
        ASSERT_TRUE(all.right()) << "mesh " << i;
    }
    EXPECT_GT(all.hits, 3'000u);
}

INSTANTIATE_TEST_SUITE_P(All, MeshStorm, ::testing::ValuesIn(usable_isas()),
                         [](const auto& level) { return std::string(to_string(level.param)); });

}  // namespace
}  // namespace luch
