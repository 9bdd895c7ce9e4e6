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
int self_hits(const Geometry& geometry, double scale, std::vector<Geometry> parts = {}) {
    Scene scene = testing::empty_scene();
    scene.geometries = std::move(parts);
    const bool only_from_above = std::holds_alternative<Heightfield>(geometry);
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
        if (only_from_above && !surface.front) continue;
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

/// Heights that no ray above them can meet twice.
Heightfield dome() {
    Image<float> heights({2, 2}, 1);
    heights(0, 0) = -3;
    return Heightfield(heights);
}

TEST(Surface, IsNotMetAgainByRaysThatLeaveIt) {
    for (const double scale : {1e-3, 1.0, 1e6}) {
        EXPECT_EQ(self_hits(Sphere{}, scale), 0) << "sphere " << scale;
        EXPECT_EQ(self_hits(Cube{.side = 2}, scale), 0) << "cube " << scale;
        EXPECT_EQ(self_hits(Plane{.limit = 2}, scale), 0) << "plane " << scale;
        EXPECT_EQ(self_hits(testing::uv_sphere(16, 24, 1), scale), 0) << "mesh " << scale;
        EXPECT_EQ(self_hits(dome(), scale), 0) << "heightfield " << scale;
        const std::vector<Geometry> parts{Sphere{.centre = {0.5, 0, 0}},
                                          testing::uv_sphere(9, 12, 1), Cube{.side = 1.5}};
        for (const GeometryId part : {1u, 2u}) {
            const Csg lens = make_csg(Csg::Operation::intersect, 0, part, parts);
            EXPECT_EQ(self_hits(lens, scale, parts), 0) << "solid " << scale;
        }
    }
}

TEST(Surface, LeavesOutWhatIsNotNeeded) {
    Scene scene = testing::empty_scene();
    testing::add(scene, Plane{.y = -1}, Lambert{});
    const Ray ray{{0.5, 0, 0.25}, {0, -1, 0}};
    WorkCounts work;
    const Hit hit = build_accelerator(scene)->closest(ray, work);
    EXPECT_EQ(surface_at(scene, ray, hit).uv, Vec2d(0.5, 0.25));
    Counts counts;
    const Needs needs = Needs().without(Part::texture_coordinates);
    EXPECT_EQ(surface_at(scene, ray, hit, needs, counts).uv, Vec2d(0));
    EXPECT_EQ(counts.of(Part::texture_coordinates), 0u);
    EXPECT_EQ(counts.of(Part::bump), 1u);
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

/// A ball cut out of a cube leaves a hollow with the ball's own texture.
TEST(Surface, HasTheTextureCoordinatesOfThePartThatIsCutOut) {
    const Sphere ball{.centre = {0, 0.5, 0}, .radius = 0.75};
    Scene solid = testing::empty_scene(), alone = testing::empty_scene();
    testing::add(alone, ball, Lambert{});
    solid.geometries = {Cube{.side = 1}, ball};
    testing::add(solid, make_csg(Csg::Operation::subtract, 0, 1, solid.geometries), Lambert{});
    const Ray into_the_hollow{{0.1, 0.3, -0.05}, {0.1, -1, 0.2}};
    WorkCounts work;
    const Hit in_solid = build_accelerator(solid)->closest(into_the_hollow, work);
    const Hit in_ball = build_accelerator(alone)->closest(into_the_hollow, work);
    ASSERT_TRUE(in_solid && in_ball);
    ASSERT_EQ(in_solid.t, in_ball.t);
    const Surface hollow = surface_at(solid, into_the_hollow, in_solid);
    EXPECT_TRUE(hollow.front);
    EXPECT_EQ(hollow.uv, surface_at(alone, into_the_hollow, in_ball).uv);
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

/// The surface that a ray meets first, and where.
Surface met(const Scene& scene, const Ray& ray) {
    WorkCounts work;
    const Hit hit = build_accelerator(scene)->closest(ray, work);
    EXPECT_TRUE(hit);
    return hit ? surface_at(scene, ray, hit) : Surface{};
}

Heightfield slope() {
    Image<float> heights({4, 4});
    for (int i = 0; i < 16; ++i) {
        heights.pixels()[static_cast<std::size_t>(i)] = static_cast<float>(i % 4 * (i / 4));
    }
    return Heightfield(heights);  // x · z
}

TEST(Surface, OfAHeightfieldHasItsTrianglesNormalAndASmoothOne) {
    Scene scene = testing::empty_scene();
    testing::add(scene, slope(), Lambert{});
    for (const double side : {1.0, -1.0}) {
        const Surface surface = met(scene, {{1.25, side * 9, 1.25}, {0, -side, 0}});
        EXPECT_NEAR(surface.position.y, 1 + 0.25 + 0.25, 1e-12);
        EXPECT_EQ(surface.front, side > 0);
        const Vec3d flat = side * glm::normalize(Vec3d(-1, 1, -1));
        EXPECT_NEAR(glm::length(surface.geometric_normal - flat), 0, 1e-12);
        const Heightfield field = slope();
        const Vec3d upper = 0.75 * field.normal(1, 1) + 0.25 * field.normal(2, 1);
        const Vec3d lower = 0.75 * field.normal(1, 2) + 0.25 * field.normal(2, 2);
        const Vec3d smooth = side * glm::normalize(0.75 * upper + 0.25 * lower);
        EXPECT_NEAR(glm::length(surface.normal - smooth), 0, 1e-12);
        EXPECT_EQ(surface.uv, Vec2d(1.25 / 4, 1.25 / 4));
    }
    // The other triangle of the cell: h = 6 − 3·(2 − x) − 2·(3 − z).
    const Surface other = met(scene, {{1.75, 9, 2.75}, {0, -1, 0}});
    EXPECT_NEAR(other.position.y, 6 - 3 * 0.25 - 2 * 0.25, 1e-12);
    EXPECT_NEAR(glm::length(other.geometric_normal - glm::normalize(Vec3d(-3, 1, -2))), 0, 1e-12);
}

TEST(Surface, OfAHeightfieldIsBumpedAlongItsAxes) {
    Scene scene = testing::empty_scene();
    Image<Rgb> heights({2, 1});
    heights.pixels() = {Rgb(1), Rgb(0)};
    scene.textures.emplace_back(BumpTexture{slopes_of(heights.view()), 1, 1});
    const NodeId node = testing::add(scene, Heightfield(Image<float>({4, 4})), Lambert{},
                                     Transform::rotation(0.5, 0, 0));
    scene.nodes[node].bump = 0;
    const Transform& turned = scene.nodes[node].to_world;
    const Surface surface = met(scene, {turned.point({0, 5, 2}), {0, -1, 0}});
    const Vec3d expected = glm::normalize(turned.direction({1, 1, 0}));
    EXPECT_NEAR(glm::length(surface.normal - expected), 0, 1e-9);
}

TEST(Surface, OfASolidIsItsPartsWithTheSolidsOutside) {
    Scene scene = testing::empty_scene();
    scene.geometries = {Cube{.side = 4}, Sphere{.centre = {0, 2, 0}, .radius = 1, .uv_scaling = 3}};
    const Csg bowl = make_csg(Csg::Operation::subtract, 0, 1, scene.geometries);
    testing::add(scene, bowl, Lambert{});
    // Into the bowl: the far side of the ball, which is met from inside the ball.
    const Surface inner = met(scene, {{0, 5, 0}, {0, -1, 0}});
    EXPECT_NEAR(glm::length(inner.position - Vec3d(0, 1, 0)), 0, 1e-12);
    EXPECT_EQ(inner.normal, Vec3d(0, 1, 0));
    EXPECT_TRUE(inner.front);
    EXPECT_NEAR(inner.uv.y, 0, 1e-7);
    // Out of the bowl's ground, from within the solid.
    const Surface outwards = met(scene, {{0, -1, 0}, {0, 1, 0}});
    EXPECT_NEAR(glm::length(outwards.position - Vec3d(0, 1, 0)), 0, 1e-12);
    EXPECT_EQ(outwards.normal, Vec3d(0, -1, 0));
    EXPECT_FALSE(outwards.front);
    // The cube's top, beside the bowl.
    const Surface top = met(scene, {{1.5, 5, -1.25}, {0, -1, 0}});
    EXPECT_TRUE(top.front);
    EXPECT_EQ(top.uv, Vec2d(1.5, -1.25));
}

TEST(Surface, OfAMeshInASolidLiesInTheSolidsCoordinates) {
    Mesh ball = testing::uv_sphere(32, 48, 3);
    ball.from_frame = ball.from_frame.then(Transform::translation({50, -20, 10}));
    Scene scene = testing::empty_scene();
    scene.geometries = {ball, Cube{.centre = {50, -20, 10}, .side = 5.9}};
    const Csg cut = make_csg(Csg::Operation::intersect, 0, 1, scene.geometries);
    const NodeId node = testing::add(scene, cut, Lambert{}, Transform::rotation(0.3, 0.2, 0.1));
    const Transform& to_world = scene.nodes[node].to_world;
    for (int i = 0; i < 500; ++i) {
        const Vec3d out = glm::normalize(random_direction(Key(4).branch(i)));
        const Ray ray{to_world.point(Vec3d(50, -20, 10) + 9.0 * out), to_world.direction(-out)};
        const Surface surface = met(scene, ray);
        ASSERT_TRUE(surface.front);
        ASSERT_NEAR(glm::dot(surface.position - ray.at(6), ray.direction), 0, 0.12) << i;
        ASSERT_LE(glm::dot(surface.geometric_normal, ray.direction), -0.5) << i;
        const Vec3d along = surface.position - ray.origin;
        ASSERT_LE(glm::length(along - glm::dot(along, ray.direction) * ray.direction), 1e-5) << i;
    }
}

}  // namespace
}  // namespace luch
