#include "framework/accel/accelerator.h"

#include "framework/math/rng.h"
#include "tests/testing/everything.h"
#include "tests/testing/meshes.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <cstring>

namespace luch {
namespace {

using testing::awkward_point;
using testing::random_point;

std::vector<Ray> random_and_aimed_rays(const Scene& scene, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const Key key = Key(5).branch(i);
        Ray ray{random_point(key.branch(0), 15), random_point(key.branch(1), 1)};
        if (i % 2 == 1) ray.direction = awkward_point(scene, key.branch(2)) - ray.origin;
        if (i % 8 == 5) ray.t_max = static_cast<float>(key.uniform(6));
        if (i % 8 == 7) ray.t_min = static_cast<float>(key.uniform(7));
        if (i % 16 == 3) ray.direction[key.bits(8) % 3] = 0;
        rays.push_back(ray);
    }
    return rays;
}

TEST(Accelerator, FindsTheSameHitAsBruteForceInEveryBit) {
    const Scene scene = testing::bit_of_everything();
    const auto accelerator = build_accelerator(scene);
    WorkCounts work;
    int hits = 0;
    for (const Ray& ray : random_and_aimed_rays(scene, 100'000)) {
        const Hit hit = accelerator->closest(ray, work);
        ASSERT_EQ(hit, closest_brute(scene, ray))
            << "origin " << ray.origin.x << " " << ray.origin.y << " " << ray.origin.z;
        ASSERT_EQ(accelerator->occluded(ray, work), static_cast<bool>(hit));
        hits += hit ? 1 : 0;
    }
    EXPECT_GT(hits, 30'000);
    EXPECT_LT(work.primitives, 100'000u * 2 * 100);  // brute force would be 600 a ray
}

TEST(Accelerator, LosesNoHitAtTheBorderOfANodeThatIsFarAway) {
    // A flat square fills its box to the last bit: rays aimed at its corners and borders from afar
    // meet it, or not, by the rounding in its own frame, which its world box must allow for.
    Mesh square = testing::triangle({-1, 0, -1}, {1, 0, -1}, {1, 0, 1});
    square.triangles.push_back(square.triangles[0]);
    Scene scene = testing::empty_scene();
    testing::add(scene, square, Lambert{}, Transform::translation({148376, 1234, -223423}));
    const auto accelerator = build_accelerator(scene);
    WorkCounts work;
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Key key = Key(13).branch(i);
        const Vec3d origin = scene.nodes[0].to_world.point(random_point(key.branch(0), 1000));
        const Ray ray{origin, awkward_point(scene, key.branch(1)) - origin};
        const Hit hit = accelerator->closest(ray, work);
        ASSERT_EQ(hit, closest_brute(scene, ray)) << i;
        hits += hit ? 1 : 0;
    }
    EXPECT_GT(hits, 1000);
}

TEST(Accelerator, FindsWhatOneNodeAloneWouldGive) {
    const Scene scene = testing::bit_of_everything();
    const auto accelerator = build_accelerator(scene);
    WorkCounts work;
    for (const Ray& ray : random_and_aimed_rays(scene, 2'000)) {
        Hit best = Hit{.t = ray.t_max};
        for (NodeId node = 0; node < scene.nodes.size(); ++node) {
            const Hit hit = accelerator->closest_in(node, ray, work);
            if (hit && nearer(hit, best)) best = hit;
        }
        ASSERT_EQ(best ? best : Hit{}, accelerator->closest(ray, work));
    }
}

TEST(Accelerator, PrefersTheFirstNodeAndTriangleAtEqualDistance) {
    Scene scene = testing::empty_scene();
    for (int i = 0; i < 3; ++i) {
        Mesh twice = testing::triangle({-1, -1, 5}, {1, -1, 5}, {0, 1, 5});
        twice.triangles.push_back(twice.triangles[0]);
        testing::add(scene, twice, Lambert{});
    }
    WorkCounts work;
    const Hit hit = build_accelerator(scene)->closest({{0, 0, 0}, {0, 0, 1}}, work);
    EXPECT_EQ(hit.node, 0u);
    EXPECT_EQ(hit.primitive, 0u);
}

TEST(Accelerator, MissesInAnEmptyScene) {
    const Scene scene = testing::empty_scene();
    WorkCounts work;
    EXPECT_EQ(build_accelerator(scene)->closest({{0, 0, 0}, {0, 0, 1}}, work), Hit{});
    EXPECT_FALSE(build_accelerator(scene)->occluded({{0, 0, 0}, {0, 0, 1}}, work));
}

TEST(Accelerator, MissesForRaysThatAreNoRays) {
    const Scene scene = testing::bit_of_everything();
    const auto accelerator = build_accelerator(scene);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    constexpr float nanf = std::numeric_limits<float>::quiet_NaN();
    const Vec3d o{0, 3, -10}, d{0, 0, 1};
    const std::vector<Ray> rays{
        {{nan, 0, 0}, d},    {{inf, 0, 0}, d}, {o, {nan, 0, 1}}, {o, {0, inf, 1}}, {o, {0, 0, 0}},
        {o, d, nanf, 1e30f}, {o, d, 0, nanf},  {o, d, 0, -1},    {o, d, 2, 1},
    };
    WorkCounts work;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(accelerator->closest(rays[i], work), Hit{}) << i;
        EXPECT_EQ(closest_brute(scene, rays[i]), Hit{}) << i;
        EXPECT_FALSE(accelerator->occluded(rays[i], work)) << i;
    }
}

TEST(Accelerator, FindsTheSameHitsFarFromTheOriginAndAtEveryScale) {
    for (const double scale : {1e-20, 1e-3, 1e6, 1e20}) {
        const Transform moved = Transform::scaling(Vec3d(scale));
        Scene scene = testing::empty_scene();
        testing::add(scene, testing::uv_sphere(8, 12, 1), Lambert{}, moved);
        const auto accelerator = build_accelerator(scene);
        WorkCounts work;
        for (int i = 0; i < 500; ++i) {
            const Ray ray{scale * random_point(Key(8).branch(i), 3),
                          random_point(Key(9).branch(i), 1)};
            ASSERT_EQ(accelerator->closest(ray, work), closest_brute(scene, ray));
        }
        const Ray through{{0, 0, -5 * scale}, {0, 0, 1}};
        ASSERT_TRUE(accelerator->closest(through, work)) << scale;
        EXPECT_NEAR(accelerator->closest(through, work).t / (4 * scale), 1, 0.02);
    }
}

TEST(Accelerator, SurvivesRandomBitsForCorners) {
    Mesh mesh;
    for (int i = 0; i < 3000; ++i) {
        const auto bits = static_cast<std::uint32_t>(Key(10).bits(i));
        float value = 0;
        static_assert(sizeof value == sizeof bits);
        std::memcpy(&value, &bits, sizeof value);
        if (i % 3 == 0) mesh.positions.emplace_back();
        mesh.positions.back()[i % 3] = value;
    }
    for (std::uint32_t i = 0; i + 2 < mesh.positions.size(); ++i) {
        mesh.triangles.push_back({.position = {i, i + 1, i + 2}, .normal = {}, .uv = {}});
    }
    Scene scene = testing::empty_scene();
    testing::add(scene, mesh, Lambert{});
    const auto accelerator = build_accelerator(scene);
    WorkCounts work;
    for (int i = 0; i < 1000; ++i) {
        const Ray ray{random_point(Key(11).branch(i), 1), random_point(Key(12).branch(i), 1)};
        const Hit hit = accelerator->closest(ray, work);
        ASSERT_EQ(hit, closest_brute(scene, ray)) << i;
        ASSERT_FALSE(std::isnan(hit.t) || std::isnan(hit.u) || std::isnan(hit.v));
    }
}

TEST(Accelerator, OpensNoMoreBoxesForARayAlongAnAxisThanForOneBesideIt) {
    Scene scene = testing::empty_scene();
    testing::add_shape(scene, testing::uv_sphere(100, 200, 1));
    const auto accelerator = build_accelerator(scene);
    const auto boxes = [&](const Vec3d& direction) {
        WorkCounts work;
        accelerator->closest({{0.301, 0.207, -3}, direction}, work);
        return work.boxes;
    };
    EXPECT_LE(boxes({0, 0, 1}), 2 * boxes({1e-4, 1e-4, 1}));
}

}  // namespace
}  // namespace luch
