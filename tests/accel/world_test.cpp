#include "framework/accel/accelerator.h"
#include "framework/accel/wide/build.h"
#include "framework/math/rng.h"
#include "framework/scene/scene.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

/// Spheres and triangles of many sizes around `middle`, every other one stretched a lot.
Scene scattered(int count, const Vec3d& middle, double largest, bool stretched, Key key) {
    Scene scene;
    scene.geometries.emplace_back(Sphere{});
    Mesh triangle;
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    triangle.triangles = {{.position = {0, 1, 2}, .normal = {}, .uv = {}}};
    scene.geometries.emplace_back(triangle);
    scene.materials.emplace_back(Lambert{});
    for (int i = 0; i < count; ++i) {
        const Key at = key.branch(i);
        const Vec3d place(at.uniform(0), at.uniform(1), at.uniform(2));
        const double size = largest * std::pow(10.0, -2.5 * at.uniform(3));
        const bool even = i % 2 == 0 || !stretched;
        const Vec3d stretch = even ? Vec3d(size) : Vec3d(size, 1e-4 * size, 100 * size);
        const Transform transform = Transform::scaling(stretch)
                                        .then(Transform::rotation(i, 2 * i, 3 * i))
                                        .then(Transform::translation(middle + place));
        add_node(scene, "node", i % 3 == 0 ? 1 : 0, 0, transform);
    }
    return scene;
}

/// A ray from within or from afar to somewhere in the scattered things.
Ray aimed(const Vec3d& middle, double distance, Key key) {
    const Vec3d from =
        middle + distance * Vec3d(key.uniform(0) - 0.5, key.uniform(1) - 0.5, key.uniform(2) - 0.5);
    const Vec3d to = middle + Vec3d(key.uniform(3), key.uniform(4), key.uniform(5));
    Vec3d direction = to - from;
    const double choice = key.uniform(6);
    if (choice < 0.1) direction[static_cast<int>(30 * choice)] = 0;
    return {from, direction, 0, std::numeric_limits<float>::infinity()};
}

struct Case {
    const char* name;
    Vec3d middle;
    double distance;
};

TEST(World, LosesNoNodeWhereverTheRayStarts) {
    const Case cases[] = {{"within", {0, 0, 0}, 1},
                          {"outside", {0, 0, 0}, 10},
                          {"from afar", {0, 0, 0}, 1e4},
                          {"far from the origin", {148376, 1234, -223423}, 3}};
    for (const Case& each : cases) {
        const Scene scene = scattered(60, each.middle, 0.3, true, Key(7));
        const auto accelerator = build_accelerator(scene);
        int hits = 0;
        for (int i = 0; i < 4000; ++i) {
            Ray ray = aimed(each.middle, each.distance, Key(11).branch(i));
            if (i % 20 == 0) ray.direction *= i % 40 == 0 ? 1e37 : 1e-37;
            WorkCounts work;
            const Hit expected = closest_brute(scene, ray);
            hits += expected ? 1 : 0;
            ASSERT_EQ(accelerator->closest(ray, work), expected) << each.name << ", ray " << i;
            ASSERT_EQ(accelerator->occluded(ray, work), static_cast<bool>(expected));
        }
        EXPECT_GT(hits, 400) << each.name;
    }
}

TEST(World, OpensFewNodesOfThousands) {
    const Vec3d middle(148376, 1234, -223423);
    const Scene scene = scattered(5000, middle, 0.001, false, Key(3));
    const auto accelerator = build_accelerator(scene);
    WorkCounts work;
    constexpr int rays = 200;
    for (int i = 0; i < rays; ++i) accelerator->closest(aimed(middle, 1, Key(5).branch(i)), work);
    EXPECT_LT(work.boxes / rays, 500u);
}

TEST(World, BuildsATreeWithEveryBoxOnceInItsParentsBounds) {
    std::vector<Box> boxes;
    for (int i = 0; i < 1000; ++i) {
        const Key key = Key(2).branch(i);
        const Vec3 lo(key.uniform(0), key.uniform(1), key.uniform(2));
        boxes.push_back({lo, lo + Vec3(0.1f)});
        if (i % 10 == 0) boxes.push_back(boxes.back());  // twins
    }
    const wide::Tree tree = wide::built(boxes, Isa::plain);
    std::vector<int> seen(boxes.size());
    for (const wide::Node& node : tree.nodes) {
        for (int slot = 0; (node.used >> slot & 1) != 0; ++slot) {
            const Box outer = node.box(slot);
            if ((node.child[slot] & wide::leaf_bit) != 0) {
                const std::uint32_t number = node.child[slot] & ~wide::leaf_bit;
                ++seen.at(number);
                EXPECT_EQ(outer.lo, boxes[number].lo);
                EXPECT_EQ(outer.hi, boxes[number].hi);
                continue;
            }
            const wide::Node& child = tree.nodes.at(node.child[slot]);
            for (int k = 0; (child.used >> k & 1) != 0; ++k) {
                Box both = outer;
                both.grow(child.box(k));
                EXPECT_EQ(both.lo, outer.lo);
                EXPECT_EQ(both.hi, outer.hi);
            }
        }
    }
    EXPECT_TRUE(std::ranges::all_of(seen, [](int n) { return n == 1; }));
}

TEST(World, EndsForTenThousandIdenticalBoxesAndForNone) {
    const std::vector<Box> twins(10000, Box{{0, 0, 0}, {1, 1, 1}});
    EXPECT_LT(wide::built(twins, Isa::plain).nodes.size(), 10000u);
    EXPECT_EQ(wide::built(std::span<const Box>(), Isa::plain).nodes.size(), 1u);
}

}  // namespace
}  // namespace luch
