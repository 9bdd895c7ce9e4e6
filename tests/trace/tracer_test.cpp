#include "framework/trace/tracer.h"

#include "tests/testing/everything.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

TEST(Tracer, CountsEveryRayOnceByKind) {
    const Scene scene = testing::bit_of_everything();
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    const std::vector<Ray> rays(5, Ray{{0, 0, -10}, {0, 0, 1}});
    std::vector<Hit> hits(5);
    std::vector<std::uint8_t> blocked(5);
    tracer.closest(RayKind::primary, rays, hits);
    tracer.occluded(RayKind::shadow, rays, blocked);
    static_cast<void>(tracer.closest(RayKind::reflection, rays[0]));
    EXPECT_EQ(tracer.counts().of(RayKind::primary), 5u);
    EXPECT_EQ(tracer.counts().of(RayKind::shadow), 5u);
    EXPECT_EQ(tracer.counts().of(RayKind::reflection), 1u);
    EXPECT_EQ(tracer.counts().all_rays(), 11u);
    EXPECT_GT(tracer.counts().work.boxes, 0u);
}

TEST(Tracer, CountsTestsOfOneNodeAsObjectTestsAndNotAsRays) {
    const Scene scene = testing::bit_of_everything();
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    const std::vector<Ray> rays(3, Ray{{0, 0, -10}, {0, 0, 1}});
    const std::vector<NodeId> nodes{0, no_node, 1};
    std::vector<Hit> hits(3, Hit{.t = 7, .node = 3});
    tracer.test(nodes, rays, hits);
    EXPECT_EQ(tracer.counts().object_tests, 2u);
    EXPECT_EQ(tracer.counts().all_rays(), 0u);
    EXPECT_EQ(hits[1], Hit{});
}

}  // namespace
}  // namespace luch
