#include "framework/accel/shapes.h"

#include "framework/math/rng.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

TEST(SphereShape, IsMetAtTheNearSideAndFromInsideAtTheFarOne) {
    const Sphere sphere{.centre = {0, 0, 5}, .radius = 2};
    EXPECT_DOUBLE_EQ(intersect(sphere, {{0, 0, 0}, {0, 0, 1}})->t, 3);
    EXPECT_DOUBLE_EQ(intersect(sphere, {{0, 0, 5}, {0, 0, 1}})->t, 2);
    EXPECT_DOUBLE_EQ(intersect(sphere, {{0, 0, 0}, {0, 0, 1}, 4, 100})->t, 7);
    EXPECT_FALSE(intersect(sphere, {{0, 0, 8}, {0, 0, 1}}));
    EXPECT_FALSE(intersect(sphere, {{0, 2.001, 0}, {0, 0, 1}}));
}

/// t of a ray at a unit sphere's near side in long double, straight from the quadratic.
long double reference_t(const Ray& ray, const Sphere& sphere) {
    using T = long double;
    T a = 0, b = 0, c = -T(sphere.radius) * sphere.radius;
    for (int k = 0; k < 3; ++k) {
        const T o = T(ray.origin[k]) - sphere.centre[k], d = ray.direction[k];
        a += d * d;
        b += o * d;
        c += o * o;
    }
    return (-b - std::sqrt(b * b - a * c)) / a;
}

TEST(SphereShape, KeepsItsDigitsFarAway) {
    // Not a power of two, so that nothing cancels by luck.
    const Sphere sphere{.centre = {0, 0, 0}, .radius = 1};
    for (int i = 0; i < 1000; ++i) {
        const Key key = Key(1).branch(i);
        const Vec3d from{0, 0, -1.0123e4};
        const Vec3d to = 0.7 * (2.0 * Vec3d(key.uniform(0), key.uniform(1), 0.5) - 1.0);
        const Ray ray{from, glm::normalize(to - from)};
        const auto hit = intersect(sphere, ray);
        ASSERT_TRUE(hit);
        const long double t = reference_t(ray, sphere);
        ASSERT_LE(std::abs(static_cast<double>((hit->t - t) / t)), 1e-12);
    }
}

TEST(SphereShape, KeepsItsDigitsOnAPlanet) {
    const Sphere planet{.centre = {0, -1e6, 0}, .radius = 1e6};
    const Ray down{{0, 1, 0}, glm::normalize(Vec3d(1, -1, 0))};
    const auto hit = intersect(planet, down);
    ASSERT_TRUE(hit);
    const long double t = reference_t(down, planet);
    EXPECT_LE(std::abs(static_cast<double>((hit->t - t) / t)), 1e-6);
}

TEST(SphereShape, TellsTwoShellsApart) {
    const Sphere inner{.centre = {0, 0, 0}, .radius = 1};
    const Sphere outer{.centre = {0, 0, 0}, .radius = 1 + 4e-5};
    for (int i = 0; i < 1000; ++i) {
        const Key key = Key(2).branch(i);
        const Ray ray{{0, 0, -3}, Vec3d(0.6 * key.uniform(0) - 0.3, 0.6 * key.uniform(1) - 0.3, 3)};
        const auto near = intersect(outer, ray), far = intersect(inner, ray);
        if (!far) continue;
        ASSERT_LT(static_cast<float>(near->t), static_cast<float>(far->t));
    }
}

TEST(CubeShape, KnowsItsFaces) {
    const Cube cube{.centre = {0, 0, 0}, .side = 2};
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {-1, 1}) {
            Ray ray{{0.1, 0.2, 0.3}, {0, 0, 0}};
            ray.origin[axis] = 5.0 * side;
            ray.direction[axis] = -side;
            const auto hit = intersect(cube, ray);
            ASSERT_TRUE(hit);
            EXPECT_DOUBLE_EQ(hit->t, 4);
            EXPECT_EQ(hit->primitive, 2u * axis + (side > 0 ? 1u : 0u));
        }
    }
    EXPECT_DOUBLE_EQ(intersect(cube, {{0, 0, 0}, {0, 0, 1}})->t, 1);
    EXPECT_EQ(intersect(cube, {{0, 0, 0}, {0, 0, 1}})->primitive, 5u);
    EXPECT_FALSE(intersect(cube, {{1.5, 0, -5}, {0, 0, 1}}));
}

TEST(PlaneShape, EndsAtItsLimit) {
    const Plane square{.y = 1, .limit = 2};
    EXPECT_DOUBLE_EQ(intersect(square, {{2, 3, -2}, {0, -1, 0}})->t, 2);
    EXPECT_FALSE(intersect(square, {{2.001, 3, 0}, {0, -1, 0}}));
    EXPECT_FALSE(intersect(square, {{0, 3, 0}, {1, 0, 0}}));
    EXPECT_TRUE(intersect(Plane{.y = 1}, {{1e9, 3, 0}, {0, -1, 0}}));
}

}  // namespace
}  // namespace luch
