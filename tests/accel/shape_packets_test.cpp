#include "framework/accel/shape_packets.h"

#include "framework/accel/node_hit.h"
#include "framework/math/rng.h"

#include <gtest/gtest.h>

// Planes, spheres and cubes in packets are those of single rays, bit for bit.
namespace luch {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// Numbers of all sizes, with those that lie in faces, centres and beyond all reason.
double odd_number(Key key) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double numbers[] = {nan, HUGE_VAL, -HUGE_VAL, 0.0,   -0.0,  1e-310, 1e-200, -1e-160,
                                  1,   -1,       0.5,       1e150, 1e300, 2,      -2,     0.25};
    if (key.bits(0) % 4 != 0) return 4 * key.uniform(1) - 2;
    return numbers[key.bits(2) % std::size(numbers)];
}

Vec3d odd_point(Key key) {
    return {odd_number(key.branch(0)), odd_number(key.branch(1)), odd_number(key.branch(2))};
}

RayPacket odd_rays(Key key, int count) {
    RayPacket rays;
    rays.origin = odd_point(key.branch(1));
    if (key.bits(2) % 3 == 0) rays.t_min = static_cast<float>(key.uniform(3));
    for (int i = 0; i < count; ++i) {
        const Key of = key.branch(4).branch(i);
        const float t_max = of.bits(1) % 4 == 0 ? static_cast<float>(3 * of.uniform(2)) : infinite;
        rays.add(odd_point(of.branch(5)), of.bits(3) % 16 == 0 ? -infinite : t_max);
    }
    return rays;
}

std::vector<Geometry> odd_shapes(Key key) {
    return {Plane{odd_number(key.branch(0))},
            Plane{key.uniform(1), key.uniform(2)},
            Sphere{odd_point(key.branch(3)), 2 * key.uniform(4)},
            Sphere{Vec3d(0), 1e6},
            Cube{odd_point(key.branch(5)), 2 * key.uniform(6)},
            Cube{Vec3d(0.5), 1}};
}

/// What a single ray meets; t infinite: nothing.
Hit single(const Geometry& geometry, const Transform* to_object, const Ray& ray) {
    if (!is_sound(ray)) return {};
    const Ray seen = shape_ray(to_object != nullptr ? to_object->ray(ray) : ray);
    const auto met = [&](const auto& shape) -> std::optional<ShapeHit> {
        using Shape = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<Shape, Plane> || std::is_same_v<Shape, Sphere> ||
                      std::is_same_v<Shape, Cube>) {
            return intersect(shape, seen);
        }
        return std::nullopt;
    };
    const std::optional<ShapeHit> hit = std::visit(met, geometry);
    return hit ? Hit{static_cast<float>(hit->t), 0, 0, 0, hit->primitive} : Hit{};
}

class ShapePackets : public ::testing::TestWithParam<Isa> {};

TEST_P(ShapePackets, MeetWhatSingleRaysMeet) {
    int hits = 0, exits = 0;
    for (int round = 0; round < 300; ++round) {
        const Key key = Key(20).branch(round);
        const Transform turned = Transform::rotation(key.uniform(1), key.uniform(2), key.uniform(3))
                                     .then(Transform::translation({0.3, 0, -0.1}));
        const Transform* const to_object = round % 2 == 0 ? &turned : nullptr;
        const RayPacket rays = odd_rays(key, round % 3 == 0 ? 37 : RayPacket::capacity);
        for (const Geometry& geometry : odd_shapes(key.branch(7))) {
            wide::ShapeHits met;
            ASSERT_TRUE(meet(geometry, to_object, rays, wide::kernels(GetParam()), met));
            for (int i = 0; i < rays.count; ++i) {
                const Hit one = single(geometry, to_object, rays.ray(i));
                ASSERT_EQ(met.t[i], one.t) << "shape " << geometry.index() << ", ray " << i;
                if (!one) continue;
                ASSERT_EQ(met.face[i], one.primitive);
                ++hits;
                exits += one.primitive == 5 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(hits, 20'000);
    EXPECT_GT(exits, 100);
}

TEST_P(ShapePackets, MeetNothingAtTheVeryEndsOfARay) {
    const auto t_between = [](float t_min, float t_max) {
        RayPacket rays;
        rays.t_min = t_min;
        rays.add({0, 0, 1}, t_max);
        wide::ShapeHits met;
        meet(Sphere{{0, 0, 3}, 1}, nullptr, rays, wide::kernels(GetParam()), met);
        return met.t[0];
    };
    EXPECT_EQ(t_between(0, infinite), 2);
    EXPECT_EQ(t_between(2, infinite), 4);
    EXPECT_EQ(t_between(0, 2), infinite);
    EXPECT_EQ(t_between(2, 4), infinite);
}

TEST_P(ShapePackets, LeaveOtherShapesAlone) {
    wide::ShapeHits met;
    EXPECT_FALSE(meet(Mesh{}, nullptr, RayPacket(), wide::kernels(GetParam()), met));
    EXPECT_FALSE(meet(Csg{}, nullptr, RayPacket(), wide::kernels(GetParam()), met));
}

INSTANTIATE_TEST_SUITE_P(All, ShapePackets, ::testing::ValuesIn(usable_isas()),
                         [](const auto& level) { return std::string(to_string(level.param)); });

/// A floor without end, which is met before all else, and the top of a cube in it.
TEST(Accelerator, GivesTiesToTheLowerNodeInPackets) {
    Scene scene;
    scene.geometries = {Cube{{0, -0.5, 0}, 1}, Plane{}};
    scene.materials.emplace_back(Lambert{});
    add_node(scene, "cube", 0, 0, {});
    add_node(scene, "floor", 1, 0, {});
    const auto accelerator = build_accelerator(scene);
    RayPacket rays;
    rays.origin = {0, 2, 0};
    rays.add({0, -1, 0}, infinite);
    rays.add({1, -1, 0}, infinite);
    HitPacket hits;
    WorkCounts work;
    accelerator->closest(rays, hits, work);
    EXPECT_EQ(hits.hit(0), (Hit{2, 0, 0, 0, 3}));
    EXPECT_EQ(hits.hit(1), (Hit{2, 0, 0, 1, 0}));
}

TEST(Accelerator, ImprovesHitsWithOneNode) {
    Scene scene;
    scene.geometries = {Sphere{{0, 0, 5}, 1}, Sphere{{0, 0, 3}, 1}};
    scene.materials.emplace_back(Lambert{});
    add_node(scene, "far", 0, 0, {});
    add_node(scene, "near", 1, 0, {});
    const auto accelerator = build_accelerator(scene);
    RayPacket rays;
    rays.add({0, 0, 1}, infinite);
    rays.add({0, 0, 1}, -infinite);
    rays.add({1, 0, 0}, infinite);
    HitPacket hits;
    for (int i = 0; i < 3; ++i) hits.set(i, Hit{});
    WorkCounts work;
    accelerator->improve(1, rays, hits, work);
    EXPECT_EQ(hits.hit(0), (Hit{2, 0, 0, 1, 0}));
    EXPECT_EQ(hits.hit(1), Hit{}) << "it looks for nothing";
    EXPECT_EQ(hits.hit(2), Hit{});
    accelerator->improve(0, rays, hits, work);
    EXPECT_EQ(hits.hit(0), (Hit{2, 0, 0, 1, 0})) << "the other one is farther";
}

}  // namespace
}  // namespace luch
