#include "framework/trace/surface.h"

#include "framework/math/rng.h"
#include "tests/testing/everything.h"
#include "tests/testing/meshes.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

Vec3d random_direction(Key key) {
    return 2.0 * Vec3d(key.uniform(0), key.uniform(1), key.uniform(2)) - 1.0;
}

struct Aimed {
    Ray ray;
    Hit hit;
};

std::vector<Aimed> hits_in(const Accelerator& accelerator, int rays) {
    std::vector<Aimed> hits;
    WorkCounts work;
    for (int i = 0; i < rays; ++i) {
        const Key key = Key(1).branch(i);
        const Ray ray{12.0 * random_direction(key.branch(0)), random_direction(key.branch(1))};
        const Hit hit = accelerator.closest(ray, work);
        if (hit) hits.push_back({ray, hit});
    }
    return hits;
}

TEST(Surface, LiesWhereTheRayHitAndFacesIt) {
    const Scene scene = testing::bit_of_everything();
    const auto accelerator = build_accelerator(scene);
    for (const auto& [ray, hit] : hits_in(*accelerator, 20'000)) {
        const Surface surface = surface_at(scene, ray, hit);
        const double length = glm::length(ray.direction);
        ASSERT_LE(glm::length(surface.position - ray.at(hit.t)),
                  1e-4 * length * hit.t + 100 * surface.error);
        ASSERT_LE(glm::dot(surface.geometric_normal, ray.direction), 0);
        ASSERT_LE(glm::dot(surface.normal, ray.direction), 0);
        ASSERT_NEAR(glm::length(surface.normal), 1, 1e-12);
        ASSERT_NEAR(glm::length(surface.geometric_normal), 1, 1e-12);
    }
}

/// A flat or convex surface cannot be met again by a ray that leaves it on the outside.
int self_hits(const Geometry& geometry, double scale) {
    Scene scene = testing::empty_scene();
    testing::add(scene, geometry, Lambert{},
                 Transform::rotation(0.3, 0.5, 0.7).then(Transform::scaling(Vec3d(scale))));
    const auto accelerator = build_accelerator(scene);
    WorkCounts work;
    int met_again = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Key key = Key(2).branch(i);
        const Vec3d origin = 5 * scale * glm::normalize(random_direction(key.branch(0)));
        const Ray in{origin, scale * random_direction(key.branch(1)) - origin};
        const Hit hit = accelerator->closest(in, work);
        if (!hit) continue;
        const Surface surface = surface_at(scene, in, hit);
        Vec3d out = glm::normalize(random_direction(key.branch(2)));
        // From grazing to straight up.
        out += surface.geometric_normal * (1e-3 - glm::dot(out, surface.geometric_normal));
        out += key.uniform(9) * surface.geometric_normal;
        met_again += accelerator->closest(leaving(surface, out), work) ? 1 : 0;
        const Vec3d light = surface.position + scale * 30 * out;
        met_again += accelerator->occluded(shadow_ray(surface, light), work) ? 1 : 0;
    }
    return met_again;
}

TEST(Surface, IsNotMetAgainByRaysThatLeaveIt) {
    for (const double scale : {1e-3, 1.0, 1e6}) {
        EXPECT_EQ(self_hits(Sphere{}, scale), 0) << "sphere " << scale;
        EXPECT_EQ(self_hits(Cube{.side = 2}, scale), 0) << "cube " << scale;
        EXPECT_EQ(self_hits(Plane{.limit = 2}, scale), 0) << "plane " << scale;
        EXPECT_EQ(self_hits(testing::uv_sphere(16, 24, 1), scale), 0) << "mesh " << scale;
    }
}

TEST(Surface, LeavesOutWhatIsNotNeeded) {
    Scene scene = testing::empty_scene();
    testing::add(scene, Plane{.y = -1}, Lambert{});
    const Ray ray{{0.5, 0, 0.25}, {0, -1, 0}};
    WorkCounts work;
    const Hit hit = build_accelerator(scene)->closest(ray, work);
    EXPECT_EQ(surface_at(scene, ray, hit).uv, Vec2d(0.5, 0.25));
    EXPECT_EQ(surface_at(scene, ray, hit, {.uv = false, .bump = false}).uv, Vec2d(0));
}

TEST(Surface, HasTheCoursesTextureCoordinates) {
    const Sphere sphere{.centre = {1, 2, 3}, .radius = 2, .uv_scaling = 4};
    Scene scene = testing::empty_scene();
    testing::add(scene, sphere, Lambert{});
    WorkCounts work;
    const Ray ray{{1, 2, -9}, {0, 0, 1}};  // meets it at local (0, 0, −1)
    const Hit hit = build_accelerator(scene)->closest(ray, work);
    const Vec2d uv = surface_at(scene, ray, hit).uv;
    EXPECT_NEAR(uv.x, 4 * (-0.25 + 0.5), 1e-12);
    EXPECT_NEAR(uv.y, 4 * -0.5, 1e-12);
}

TEST(Surface, KeepsNormalsRightUnderNonUniformScale) {
    Scene scene = testing::empty_scene();
    testing::add(scene, Sphere{}, Lambert{}, Transform::scaling({1, 2, 1}));
    const Vec3d on{std::sqrt(0.5), 2 * std::sqrt(0.5), 0};
    const Ray ray{on + Vec3d(1, 0, 0), {-1, 0, 0}};
    WorkCounts work;
    const Hit hit = build_accelerator(scene)->closest(ray, work);
    // The gradient of x² + y²/4 + z² there is (2x, y/2, 0).
    const Vec3d expected = glm::normalize(Vec3d(2 * on.x, on.y / 2, 0));
    EXPECT_NEAR(glm::length(surface_at(scene, ray, hit).normal - expected), 0, 1e-12);
}

}  // namespace
}  // namespace luch
