#include "framework/accel/hit.h"

#include "framework/math/rng.h"
#include "tests/testing/meshes.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

Vec3 random_point(Key key) {
    return Vec3(2.0 * Vec3d(key.uniform(0), key.uniform(1), key.uniform(2)) - 1.0);
}

/// The sign of (a × b) · d, by long double products that are exact for these small floats.
int exact_sign(const Vec3& a, const Vec3& b, const Vec3& d) {
    using T = long double;
    const T x = T(a.y) * b.z - T(a.z) * b.y, y = T(a.z) * b.x - T(a.x) * b.z,
            z = T(a.x) * b.y - T(a.y) * b.x;
    const T value = x * d.x + y * d.y + z * d.z;
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

TEST(EdgeSign, IsNeverWrongWhenItIsNotZero) {
    for (int i = 0; i < 100'000; ++i) {
        const Key key = Key(1).branch(i);
        const Vec3 a = random_point(key.branch(0)), b = random_point(key.branch(1));
        // Nearly in the plane of a and b, where the float value is all rounding.
        const auto u = static_cast<float>(key.uniform(5)), v = static_cast<float>(key.uniform(6));
        const Vec3 d = u * a + v * b;
        const int sign = edge_sign(a, b, d);
        ASSERT_TRUE(sign == 0 || sign == exact_sign(a, b, d)) << i;
    }
}

TEST(EdgeSign, TurnsWithTheEdge) {
    for (int i = 0; i < 10'000; ++i) {
        const Key key = Key(2).branch(i);
        const Vec3 a = random_point(key.branch(0)), b = random_point(key.branch(1));
        const Vec3 d = random_point(key.branch(2));
        ASSERT_EQ(edge_sign(a, b, d), -edge_sign(b, a, d));
    }
}

TEST(EdgeSign, HoldsAtScalesWhereFloatsOverflowAndUnderflow) {
    const Vec3 a{1, 0, 0.5f}, b{0, 1, 0.25f}, d{0.25f, 0.5f, 1};
    for (const float scale : {1e-30f, 1e-20f, 1e-10f, 1.0f, 1e10f, 1e20f, 1e30f}) {
        EXPECT_EQ(edge_sign(a * scale, b * scale, d * scale), 1) << scale;
        EXPECT_EQ(edge_sign(b * scale, a * scale, d * scale), -1) << scale;
    }
}

TEST(Slab, LetsARayInAFaceOrAnEdgePassWhicheverAxisItFollows) {
    const Box box{{-1, -1, -1}, {1, 1, 1}};
    for (int axis = 0; axis < 3; ++axis) {
        const int second = (axis + 1) % 3, third = (axis + 2) % 3;
        for (const double zero : {0.0, -0.0}) {
            for (const double side : {-1.0, 1.0}) {
                Ray in_face{Vec3d(0), Vec3d(zero)};
                in_face.direction[axis] = 1;
                in_face.origin[axis] = -5;
                Ray beside = in_face, in_edge = in_face;
                in_face.origin[second] = side;
                in_edge.origin[second] = in_edge.origin[third] = side;
                beside.origin[third] = side * 1.001;
                for (const Ray& ray : {in_face, in_edge}) {
                    const Interval interval = slab(box, object_ray(ray));
                    EXPECT_EQ(interval.near, 4);
                    EXPECT_GE(interval.far, 6);
                }
                const Interval miss = slab(box, object_ray(beside));
                EXPECT_GT(miss.near, miss.far);
            }
        }
    }
}

TEST(Slab, NestsIntervalsOfNestedBoxesExactly) {
    for (int i = 0; i < 100'000; ++i) {
        const Key key = Key(3).branch(i);
        Box inner, outer;
        for (int k = 0; k < 2; ++k) inner.grow(random_point(key.branch(k)));
        outer = inner;
        outer.grow(random_point(key.branch(2)));
        const Ray ray{Vec3d(random_point(key.branch(3))) * 3.0, Vec3d(random_point(key.branch(4)))};
        const Interval small = slab(inner, object_ray(ray));
        const Interval large = slab(outer, object_ray(ray));
        ASSERT_LE(large.near, small.near);
        ASSERT_GE(large.far, small.far);
    }
}

TEST(Triangle, IsHitWhereDoubleArithmeticHitsIt) {
    const Vec3 p0{0, 0, 1}, p1{1, 0, 1.5f}, p2{0, 1, 2};
    const Ray ray{{0.25, 0.25, 0}, {0, 0, 2}};
    TriangleHit hit{};
    ASSERT_TRUE(intersect_triangle(object_ray(ray), p0, p1, p2, false, hit));
    EXPECT_FLOAT_EQ(hit.u, 0.25f);
    EXPECT_FLOAT_EQ(hit.v, 0.25f);
    EXPECT_FLOAT_EQ(hit.t, 1.375f / 2);  // z = 1 + 0.25·0.5 + 0.25·1, in lengths of 2
}

TEST(Triangle, CountsOnlyBetweenTheLimitsOfTheRay) {
    const Vec3 p0{-1, -1, 1}, p1{1, -1, 1}, p2{0, 1, 1};
    TriangleHit hit{};
    EXPECT_TRUE(intersect_triangle(object_ray({{0, 0, 0}, {0, 0, 1}}), p0, p1, p2, false, hit));
    EXPECT_FALSE(
        intersect_triangle(object_ray({{0, 0, 0}, {0, 0, 1}, 0, 1}), p0, p1, p2, false, hit));
    EXPECT_FALSE(
        intersect_triangle(object_ray({{0, 0, 0}, {0, 0, 1}, 1, 9}), p0, p1, p2, false, hit));
    EXPECT_FALSE(intersect_triangle(object_ray({{0, 0, 2}, {0, 0, 1}}), p0, p1, p2, false, hit));
}

TEST(Triangle, IsSkippedFromBehindWhenCulled) {
    const Vec3 p0{-1, -1, 1}, p1{1, -1, 1}, p2{0, 1, 1};  // normal (0, 0, 4)
    TriangleHit hit{};
    EXPECT_FALSE(intersect_triangle(object_ray({{0, 0, 0}, {0, 0, 1}}), p0, p1, p2, true, hit));
    EXPECT_TRUE(intersect_triangle(object_ray({{0, 0, 2}, {0, 0, -1}}), p0, p1, p2, true, hit));
}

TEST(Triangle, IsMissedWhenItHasNoArea) {
    TriangleHit hit{};
    const ObjectRay ray = object_ray({{0, 0, 0}, {0, 0, 1}});
    const Vec3 point{0, 0, 1};
    EXPECT_FALSE(intersect_triangle(ray, point, point, point, false, hit));
    EXPECT_FALSE(intersect_triangle(ray, {-1, 0, 1}, point, {1, 0, 1}, false, hit));
}

/// Rays from the inside of a closed mesh must leave it, wherever they are aimed.
int leaks(const Mesh& mesh, int rays, int aim) {
    int missed = 0;
    for (int i = 0; i < rays; ++i) {
        const Key key = Key(4).branch(i);
        const auto triangle = static_cast<std::uint32_t>(key.bits(9) % mesh.triangles.size());
        const Vec3d origin = 0.2 * Vec3d(random_point(key.branch(0)));  // well inside, radius 0.5
        const Vec3d a(mesh.corner(triangle, 0)), b(mesh.corner(triangle, 1));
        const Vec3d target = aim == 0   ? a
                             : aim == 1 ? a + key.uniform(1) * (b - a)
                                        : Vec3d(random_point(key.branch(1)));
        const ObjectRay ray = object_ray({origin, target - origin});
        bool hit = false;
        TriangleHit where{};
        for (std::uint32_t t = 0; t < mesh.triangles.size() && !hit; ++t) {
            hit = intersect_triangle(ray, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2),
                                     false, where);
        }
        missed += hit ? 0 : 1;
    }
    return missed;
}

TEST(Triangle, LeavesNoGapAtVertices) {
    EXPECT_EQ(leaks(testing::uv_sphere(8, 12, 1), 20'000, 0), 0);
}
TEST(Triangle, LeavesNoGapAlongEdges) {
    EXPECT_EQ(leaks(testing::uv_sphere(8, 12, 1), 20'000, 1), 0);
}
TEST(Triangle, LeavesNoGapForRandomRays) {
    EXPECT_EQ(leaks(testing::uv_sphere(8, 12, 1), 20'000, 2), 0);
}

}  // namespace
}  // namespace luch
