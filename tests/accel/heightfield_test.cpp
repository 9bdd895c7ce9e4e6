#include "framework/accel/heightfield_hit.h"
#include "framework/math/rng.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

/// Random heights, every other one steep.
Heightfield rough(int width, int height, double scale = 1, std::uint64_t seed = 1) {
    Image<float> heights({width, height});
    for (std::size_t i = 0; i < heights.pixels().size(); ++i) {
        heights.pixels()[i] = static_cast<float>(scale * Key(seed).uniform(i));
    }
    return Heightfield(heights);
}

Vec3d point_over(const Heightfield& field, Key key) {
    return {field.width() * key.uniform(0), key.uniform(1), field.height() * key.uniform(2)};
}

/// The same without any walk: every triangle's plane, kept where the point lies over the triangle.
/// Rounding decides at edges, so it may lose hits there and find some twice.
std::vector<double> hits_by_brute_force(const Heightfield& field, const Ray& ray) {
    std::vector<double> hits;
    for (std::uint32_t i = 0; i < 2u * field.width() * field.height(); ++i) {
        const auto triangle = field.triangle(i);
        const double t = plane_t(field, triangle, ray);
        if (!(t > ray.t_min && t < ray.t_max)) continue;
        const double x = ray.at(t).x - triangle.x, z = ray.at(t).z - triangle.z;
        if (!(x >= 0 && z >= 0 && x <= 1 && z <= 1)) continue;
        if (triangle.k == 0 ? x + z <= 1 : x + z >= 1) hits.push_back(t);
    }
    std::sort(hits.begin(), hits.end());
    return hits;
}

TEST(HeightfieldShape, IsHitWhereItsTrianglesAre) {
    const Heightfield field = rough(13, 9);
    WorkCounts work;
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Key key = Key(2).branch(i);
        const Vec3d target = point_over(field, key.branch(0));
        Vec3d origin = point_over(field, key.branch(1));
        if (i % 2 == 0) origin += 20.0 * Vec3d(key.uniform(2) - 0.5, 1, key.uniform(3) - 0.5);
        if (i % 5 == 0) origin[i % 3] = target[i % 3];
        Ray ray{origin, target - origin};
        if (i % 7 == 0) ray.t_max = 1;
        const auto expected = hits_by_brute_force(field, ray);
        const auto hit = intersect(field, ray, work);
        ASSERT_EQ(hit.has_value(), !expected.empty()) << i;
        if (!hit) continue;
        ++hits;
        ASSERT_NEAR(hit->t, expected[0], 1e-9) << i;
        const Vec3d p = ray.at(hit->t);
        ASSERT_NEAR(p.y, height_of(field, field.triangle(hit->primitive), p.x, p.z), 1e-9);
    }
    EXPECT_GT(hits, 10'000);
}

TEST(HeightfieldShape, IsCrossedAsOftenAsItsTrianglesAre) {
    const Heightfield field = rough(13, 9);
    WorkCounts work;
    std::size_t most = 0;
    for (int i = 0; i < 5'000; ++i) {
        const Key key = Key(3).branch(i);
        const Vec3d origin = point_over(field, key.branch(0));
        const Ray ray{origin, point_over(field, key.branch(1)) - origin};
        const auto expected = hits_by_brute_force(field, ray);
        Crossings crossings(ray);
        find_crossings(field, ray, crossings, work);
        ASSERT_EQ(crossings.found().size(), expected.size()) << i;
        for (std::size_t k = 0; k < expected.size(); ++k) {
            ASSERT_EQ(crossings.found()[k].t, static_cast<float>(expected[k]));
        }
        most = std::max(most, expected.size());
    }
    EXPECT_GT(most, 4u);
}

/// Rays from above (or below) to a point of the inner grid, from near and from far away.
int misses(bool at_corners, double scale, int count) {
    const Heightfield field = rough(64, 48, scale);
    WorkCounts work;
    int missed = 0;
    for (int i = 0; i < count; ++i) {
        const Key key = Key(4).branch(i);
        const int x = 1 + static_cast<int>(key.bits(0) % 62);
        const int z = 1 + static_cast<int>(key.bits(1) % 46);
        Vec3d target{x, field.at(x, z), z};
        if (!at_corners) {
            const int edge = static_cast<int>(key.bits(2) % 3);
            const int x1 = x + (edge == 0 ? 1 : edge == 1 ? 0 : -1), z1 = z + (edge == 0 ? 0 : 1);
            target += key.uniform(3) * (Vec3d(x1, field.at(x1, z1), z1) - target);
        }
        const double side = i % 2 == 0 ? 1 : -1;
        const double far = std::pow(10.0, 6 * key.uniform(4));
        Vec3d origin{x, side * far * scale, z};
        // Within the field's own height, a ray along the ground may meet another cell or leave.
        if (i % 4 != 0) origin += Vec3d(key.uniform(5) - 0.5, 0, key.uniform(6) - 0.5);
        if (i % 8 == 1) origin.x = target.x;
        missed += !intersect(field, {origin, target - origin}, work);
    }
    return missed;
}

TEST(HeightfieldShape, HasNoHoleAtAnyCorner) {
    for (const double scale : {1e-20, 1e-3, 1.0, 1e6}) {
        EXPECT_EQ(misses(true, scale, 100'000), 0) << scale;
    }
}

TEST(HeightfieldShape, HasNoHoleAlongAnyEdge) {
    for (const double scale : {1e-20, 1e-3, 1.0, 1e6}) {
        EXPECT_EQ(misses(false, scale, 100'000), 0) << scale;
    }
}

TEST(HeightfieldShape, IsMetByRaysStraightDownAndUpAndAlongItsGridLines) {
    const Heightfield field = rough(8, 8);
    WorkCounts work;
    for (int i = 0; i <= 8; ++i) {
        const double z = i == 8 ? 8 : i + 0.25;
        EXPECT_NEAR(intersect(field, {{0.5, 5, z}, {0, -1, 0}}, work).value().t, 4.5, 0.5) << i;
        EXPECT_NEAR(intersect(field, {{8, -5, z}, {-0.0, 1, 0}}, work).value().t, 5.5, 0.5) << i;
        // In the plane x = i, and in that of a diagonal.
        EXPECT_TRUE(intersect(field, {{double(i), 4, -4}, {0, -1, 2}}, work)) << i;
        EXPECT_TRUE(intersect(field, {{i - 4.0, 4, 4.0}, {1, -1, -1}}, work) || i < 4) << i;
    }
    EXPECT_FALSE(intersect(field, {{8.001, 5, 1}, {0, -1, 0}}, work));
    EXPECT_FALSE(intersect(field, {{-0.001, 5, 1}, {0, -1, 0}}, work));
    EXPECT_FALSE(intersect(field, {{0, 0.5, 0}, {0, 0, 0}}, work));
}

TEST(HeightfieldShape, IsNotMetAlongItselfWhenItIsFlat) {
    const Heightfield flat(Image<float>({16, 16}, 0.5f));
    WorkCounts work;
    EXPECT_FALSE(intersect(flat, {{-1, 0.5, 3.3}, {1, 0, 0.1}}, work));
    EXPECT_FALSE(intersect(flat, {{-1, 0.6, 3.3}, {1, 0, 0.1}}, work));
    EXPECT_DOUBLE_EQ(intersect(flat, {{2, 1.5, 3}, {2, -0.5, 2}}, work).value().t, 2);
    EXPECT_DOUBLE_EQ(intersect(flat, {{2, -1.5, 3}, {2, 1, 2}}, work).value().t, 2);
}

TEST(HeightfieldShape, IsWalkedThroughOnlyNearItsSurface) {
    // A bowl with rough ground: rays over its rim see much empty space.
    Image<float> heights({1024, 1024});
    for (int z = 0; z < 1024; ++z) {
        for (int x = 0; x < 1024; ++x) {
            const double r = std::hypot(x - 512, z - 512);
            heights(x, z) = static_cast<float>(r * r / 2000 + 2 * Key(5).branch(x).uniform(z));
        }
    }
    const Heightfield field(heights);
    WorkCounts work;
    constexpr int rays = 2000;
    for (int i = 0; i < rays; ++i) {
        const Key key = Key(6).branch(i);
        const Vec3d origin{0, 250, 1024 * key.uniform(0)};
        const Vec3d target{300 + 424 * key.uniform(1), 20, 300 + 424 * key.uniform(2)};
        ASSERT_TRUE(intersect(field, {origin, target - origin}, work)) << i;
    }
    // A walk from cell to cell would take some 900 a ray.
    EXPECT_LT(work.primitives, rays * 20u);
    EXPECT_LT(work.boxes, rays * 120u);
    // From close above the rim, over the bowl and to the other side.
    work = {};
    for (int i = 0; i < rays; ++i) {
        const Key key = Key(8).branch(i);
        const int z = 400 + static_cast<int>(224 * key.uniform(0));
        const Vec3d origin{40, field.at(40, z) + 2.2, z};
        const Vec3d target{1000, 80, 400 + 224 * key.uniform(1)};
        ASSERT_TRUE(intersect(field, {origin, target - origin}, work)) << i;
    }
    EXPECT_LT(work.primitives, rays * 20u);
    EXPECT_LT(work.boxes, rays * 120u);
}

TEST(HeightfieldShape, AnswersForRaysOfAnySize) {
    const Heightfield field = rough(16, 16);
    WorkCounts work;
    constexpr double sizes[] = {0.0, 1e-320, 1e-300, 1e-30, 1.0, 1e30, 1e300};
    for (int i = 0; i < 20'000; ++i) {
        const Key key = Key(7).branch(i);
        Ray ray;
        for (int axis = 0; axis < 3; ++axis) {
            ray.origin[axis] = sizes[key.bits(axis) % 7] * (key.uniform(3 + axis) - 0.3);
            ray.direction[axis] = sizes[key.bits(6 + axis) % 7] * (key.uniform(9 + axis) - 0.5);
        }
        const auto hit = intersect(field, ray, work);
        if (hit) {
            ASSERT_TRUE(within(hit->t, ray)) << i;
        }
    }
    // A ray that is all but vertical is as exact as one that is.
    const auto straight = intersect(field, {{3.3, 9, 4.4}, {0, -1, 0}}, work);
    const auto leaning = intersect(field, {{3.3, 9, 4.4}, {1e-300, -1, -1e-310}}, work);
    EXPECT_DOUBLE_EQ(leaning.value().t, straight.value().t);
}

}  // namespace
}  // namespace luch
