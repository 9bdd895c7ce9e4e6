#include "framework/accel/isa.h"
#include "framework/accel/wide/build.h"
#include "framework/math/rng.h"
#include "framework/parallel/workers.h"
#include "tests/testing/kernel_objects.h"
#include "tests/testing/meshes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <set>

namespace luch {
namespace {

/// Checks that a subtree's triangles are inside its boxes; counts them.
void check_subtree(const wide::Tree& tree, std::uint32_t child, const Box& box, int depth,
                   std::multiset<std::uint32_t>& seen) {
    ASSERT_LT(depth, wide::max_depth);
    const auto inside = [&](const Vec3& p) {
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_GE(p[axis], box.lo[axis]);
            ASSERT_LE(p[axis], box.hi[axis]);
        }
    };
    if ((child & wide::leaf_bit) != 0) {
        const wide::Block& block = tree.blocks.at(child & ~wide::leaf_bit);
        for (int k = 0; k < block.count(); ++k) {
            seen.insert(block.id[k]);
            for (int corner = 0; corner < 3; ++corner) inside(block.point(corner, k));
        }
        return;
    }
    const wide::Node& node = tree.nodes.at(child);
    for (int slot = 0; slot < wide::node_width; ++slot) {
        if ((node.used >> slot & 1) == 0) continue;
        inside(node.box(slot).lo);
        inside(node.box(slot).hi);
        check_subtree(tree, node.child[slot], node.box(slot), depth + 1, seen);
    }
}

void check(const Mesh& mesh) {
    const wide::Tree tree = wide::built(mesh, usable_isas().back());
    std::multiset<std::uint32_t> seen;
    constexpr float inf = std::numeric_limits<float>::infinity();
    check_subtree(tree, 0, {Vec3(-inf), Vec3(inf)}, 0, seen);
    EXPECT_EQ(seen.size(), mesh.triangles.size());
    EXPECT_EQ(std::set<std::uint32_t>(seen.begin(), seen.end()).size(), mesh.triangles.size());
}

bool same(const wide::Tree& a, const wide::Tree& b) {
    const auto equal = [](const auto& x, const auto& y) {
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0;
    };
    return equal(a.nodes, b.nodes) && equal(a.blocks, b.blocks);
}

TEST(WideTree, HoldsEveryTriangleOnceInsideItsBoxes) {
    for (const int count : {1, 2, 4, 5, 9, 100, 5000}) {
        check(testing::triangle_soup(count, 0.1, Key(1)));
    }
    check(testing::uv_sphere(40, 60, 1));
}

TEST(WideTree, IsEmptyForNothing) {
    const wide::Tree tree = wide::built(Mesh{}, Isa::plain);
    ASSERT_EQ(tree.nodes.size(), 1u);
    EXPECT_EQ(tree.nodes[0].used, 0u);
}

TEST(WideTree, StaysShallowForTenThousandIdenticalTriangles) {
    Mesh mesh = testing::triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.triangles.resize(10'000, mesh.triangles[0]);
    check(mesh);
    EXPECT_LE(wide::built(mesh, Isa::plain).nodes.size(), 10'000u / 4);
}

TEST(WideTree, IsTheSameForAnyNumberOfThreadsAndAnyInstructions) {
    const Mesh mesh = testing::triangle_soup(20'000, 0.02, Key(2));
    const wide::Tree alone = wide::built(mesh, Isa::plain);
    for (const Isa isa : usable_isas()) {
        for (const int threads : {1, 2, 7}) {
            Workers(threads).for_each(
                1, [&](int, int) { EXPECT_TRUE(same(wide::built(mesh, isa), alone)); });
        }
    }
}

TEST(Kernels, ExportTheirEntryAndNothingThatALinkerMightShare) {
#if defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers add symbols of their own";
#endif
    testing::expect_one_entry_each(LUCH_KERNEL_OBJECTS "/luch_accel_", ".dir/wide/kernel.cpp.o",
                                   "luch::wide::kernels_");
}

}  // namespace
}  // namespace luch
