#include "framework/accel/bvh.h"

#include "framework/math/rng.h"

#include <gtest/gtest.h>

#include <set>

namespace luch {
namespace {

std::vector<Box> random_boxes(int count, float size) {
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) {
        const Key key = Key(1).branch(i);
        const Vec3 p(key.uniform(0), key.uniform(1), key.uniform(2));
        boxes.push_back({p, p + size * Vec3(key.uniform(3), key.uniform(4), key.uniform(5))});
    }
    return boxes;
}

/// Checks that every primitive is in one leaf and every box holds its children; gives the depth.
int checked_depth(const Bvh<Box>& bvh, std::span<const Box> boxes) {
    std::multiset<std::uint32_t> seen;
    std::vector<int> depth(bvh.nodes().size(), 1);
    int deepest = 0;
    for (std::size_t i = 0; i < bvh.nodes().size(); ++i) {
        const auto& node = bvh.nodes()[i];
        deepest = std::max(deepest, depth[i]);
        const auto inside = [&](const Box& box) {
            Box both = node.box;
            both.grow(box);
            EXPECT_EQ(both.lo, node.box.lo);
            EXPECT_EQ(both.hi, node.box.hi);
        };
        for (std::uint32_t k = 0; k < node.count; ++k) {
            const std::uint32_t primitive = bvh.order()[node.first + k];
            seen.insert(primitive);
            inside(boxes[primitive]);
        }
        if (node.count > 0) continue;
        for (const std::uint32_t child : {node.first, node.first + 1}) {
            EXPECT_GT(child, i);
            depth[child] = depth[i] + 1;
            inside(bvh.nodes()[child].box);
        }
    }
    EXPECT_EQ(seen.size(), boxes.size());
    EXPECT_EQ(std::set<std::uint32_t>(seen.begin(), seen.end()).size(), boxes.size());
    return deepest;
}

TEST(Bvh, HoldsEveryPrimitiveOnceInsideItsBoxes) {
    for (const int count : {1, 2, 5, 100, 5000}) {
        const auto boxes = random_boxes(count, 0.1f);
        checked_depth(Bvh<Box>(boxes), boxes);
    }
}

TEST(Bvh, IsEmptyForNothing) {
    EXPECT_TRUE(Bvh<Box>(std::span<const Box>{}).nodes().empty());
}

TEST(Bvh, StaysShallowForTenThousandIdenticalBoxes) {
    const std::vector<Box> boxes(10'000, Box{{0, 0, 0}, {1, 1, 1}});
    EXPECT_LE(checked_depth(Bvh<Box>(boxes), boxes), 16);
}

TEST(Bvh, HalvesWhatIsLeftBelowTheDepthForItsHeuristic) {
    // Bins of equal width peel off a few powers of two a level: 57 levels if nothing stopped them.
    std::vector<Box> boxes;
    for (int i = 0; i < 540; ++i) {
        Vec3 corner(0);
        corner[i / 180] = std::ldexp(1.0f, i % 180 - 120);
        boxes.push_back({corner, corner * 1.5f});
    }
    const int depth = checked_depth(Bvh<Box>(boxes), boxes);
    EXPECT_GT(depth, Bvh<Box>::sah_depth);
    EXPECT_LE(depth, Bvh<Box>::sah_depth + 6);
    EXPECT_LT(depth, Bvh<Box>::stack_size);
}

TEST(Bvh, EndsForNanAndInfiniteBoxes) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float inf = std::numeric_limits<float>::infinity();
    auto boxes = random_boxes(100, 0.1f);
    boxes[3] = {{nan, nan, nan}, {nan, nan, nan}};
    boxes[50] = {{-inf, 0, 0}, {inf, 1, 1}};
    boxes[70] = {{-3e38f, -3e38f, -3e38f}, {3e38f, 3e38f, 3e38f}};
    const Bvh<Box> bvh(boxes);
    EXPECT_EQ(bvh.order().size(), boxes.size());
    EXPECT_LT(bvh.nodes().size(), 2 * boxes.size());
}

}  // namespace
}  // namespace luch
