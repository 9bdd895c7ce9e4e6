#include "framework/trace/ray_log.h"

#include "framework/trace/whitted.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

/// A mirror for a floor, and a white ceiling with a point light under it, on the far side of a
/// small ball.
Scene mirror_and_ceiling() {
    Scene scene = testing::empty_scene();
    scene.lights.clear();
    scene.lights.emplace_back(PointLight{.position = {4, 2, 0}, .color = Rgb(1), .power = 8});
    scene.lights.emplace_back(PointLight{.position = {2, 1, 0}, .color = Rgb(1), .power = 8});
    testing::add(scene, Plane{}, Reflection{.multiplier = Rgb(1)});
    testing::add(scene, Plane{.y = 3, .limit = 20}, Lambert{});
    testing::add(scene, Sphere{.centre = {4, 2.5, 0}, .radius = 0.2}, Lambert{});
    scene.nodes[0].name = "mirror";
    scene.nodes[1].name = "ceiling";
    scene.nodes[2].name = "ball";
    return scene;
}

/// Down to the origin of the mirror, then up to the ceiling at (3, 3, 0)… and on from there.
const Ray down{{-1, 1, 0}, glm::normalize(Vec3d(1, -1, 0))};

RayLog logged(const Scene& scene, const Ray& ray, Counts* counts = nullptr, Rgb* colour = nullptr,
              bool record = true) {
    RayLog log;
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    if (record) tracer.record(&log);
    const Rgb light = Whitted(scene, Needs().without(Part::dark_shadow_rays), tracer)
                          .radiance(RayKind::primary, ray, Key(1));
    if (counts) *counts = tracer.counts();
    if (colour) *colour = light;
    return log;
}

TEST(RayLog, IsTheTreeOfAMirroredCeilingAndItsShadowRays) {
    const RayLog log = logged(mirror_and_ceiling(), down);
    const auto& rays = log.rays();
    ASSERT_EQ(rays.size(), 4u);
    EXPECT_EQ(rays[0].parent, LoggedRay::no_parent);
    EXPECT_EQ(rays[0].kind, RayKind::primary);
    EXPECT_EQ(rays[0].depth, 0);
    EXPECT_EQ(rays[0].node, 0u);
    EXPECT_NEAR(glm::length(rays[0].end()), 0, 1e-6);
    EXPECT_EQ(rays[1].parent, 0);
    EXPECT_EQ(rays[1].kind, RayKind::reflection);
    EXPECT_EQ(rays[1].depth, 1);
    EXPECT_EQ(rays[1].node, 1u);
    EXPECT_NEAR(glm::distance(rays[1].end(), Vec3d(3, 3, 0)), 0, 1e-5);
    for (const int i : {2, 3}) {
        EXPECT_EQ(rays[i].parent, 1);
        EXPECT_EQ(rays[i].kind, RayKind::shadow);
        EXPECT_EQ(rays[i].depth, 2);
        EXPECT_EQ(rays[i].fate, LoggedRay::lit);
        EXPECT_NEAR(glm::distance(rays[i].end(), Vec3d(3, 3, 0)), 0, 1e-5);
    }
}

TEST(RayLog, SaysWhatBlocksAShadowRayAndWhere) {
    // Straight up to the ceiling above the ball: the light at (4, 2, 0) is hidden by it.
    const RayLog log = logged(mirror_and_ceiling(), {{4, 2.9, 0}, {0, 1, 0}});
    ASSERT_EQ(log.rays().size(), 3u);
    EXPECT_EQ(log.rays()[1].fate, LoggedRay::blocked);
    EXPECT_EQ(log.rays()[1].node, 2u);
    EXPECT_NEAR(log.rays()[1].end().y, 2.3, 1e-5);
    EXPECT_EQ(log.rays()[2].fate, LoggedRay::lit);
}

TEST(RayLog, EndsInTheSky) {
    const RayLog log = logged(mirror_and_ceiling(), {{30, 1, 0}, {0, 1, 0}});
    ASSERT_EQ(log.rays().size(), 1u);
    EXPECT_EQ(log.rays()[0].fate, LoggedRay::sky);
    EXPECT_EQ(log.rays()[0].node, no_node);
}

TEST(RayLog, HangsEveryRayOnARayThatMetSomething) {
    const Scene scene = testing::bit_of_everything();
    const Screen screen(scene.camera, scene.settings.frame);
    for (int y = 0; y < 48; y += 3) {
        for (int x = 0; x < 64; x += 3) {
            Counts counts;
            const RayLog log = logged(scene, screen.ray(x + 0.5, y + 0.5), &counts);
            ASSERT_EQ(log.rays().size(), counts.all_rays());
            for (std::size_t i = 1; i < log.rays().size(); ++i) {
                const LoggedRay& ray = log.rays()[i];
                ASSERT_LT(ray.parent, static_cast<int>(i));
                ASSERT_GE(ray.parent, 0);
                const LoggedRay& parent = log.rays()[static_cast<std::size_t>(ray.parent)];
                EXPECT_EQ(parent.fate, LoggedRay::met);
                EXPECT_EQ(ray.depth, parent.depth + 1);
                // A shadow ray ends where its parent does, unless its light is infinitely far
                // away; every other one begins there.
                const bool comes = ray.kind == RayKind::shadow && std::isfinite(ray.ray.t_max);
                const Vec3d joint = comes ? ray.ray.at(1) : ray.ray.origin;
                EXPECT_LT(glm::distance(joint, parent.end()),
                          1e-3 * (1 + glm::length(parent.end())));
            }
        }
    }
}

TEST(RayLog, ChangesNeitherLightNorCounts) {
    const Scene scene = testing::bit_of_everything();
    const Screen screen(scene.camera, scene.settings.frame);
    for (int y = 0; y < 48; y += 5) {
        Counts with, without;
        Rgb seen, unseen;
        logged(scene, screen.ray(30, y), &with, &seen, true);
        EXPECT_TRUE(logged(scene, screen.ray(30, y), &without, &unseen, false).rays().empty());
        EXPECT_EQ(seen, unseen);
        EXPECT_EQ(with.rays, without.rays);
        EXPECT_EQ(with.work.boxes, without.work.boxes);
    }
}

TEST(RayLog, FollowsALoopOfSegments) {
    // As a path tracer would: at each end a shadow ray, then on.
    const Scene scene = mirror_and_ceiling();
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    RayLog log;
    tracer.record(&log);
    const Ray shadow{{0, 1, 0}, {1, 0, 0}, 0, 1};
    for (int path = 0; path < 2; ++path) {
        RayLog::Branch branch(tracer.log());
        for (int segment = 0; segment < 3; ++segment) {
            static_cast<void>(tracer.closest(segment == 0 ? RayKind::primary : RayKind::gi, down));
            branch.follow();
            static_cast<void>(tracer.occluded(RayKind::shadow, shadow));
        }
    }
    const std::vector<int> parents{-1, 0, 0, 2, 2, 4, -1, 6, 6, 8, 8, 10};
    ASSERT_EQ(log.rays().size(), parents.size());
    for (std::size_t i = 0; i < parents.size(); ++i) EXPECT_EQ(log.rays()[i].parent, parents[i]);
}

TEST(RayLog, TakesAnObjectTestThatHitsForThePrimaryRay) {
    const Scene scene = mirror_and_ceiling();
    const auto accelerator = build_accelerator(scene);
    Tracer tracer(*accelerator);
    RayLog log;
    tracer.record(&log);
    const std::array<NodeId, 3> nodes{0, 2, no_node};
    const std::array<Ray, 3> rays{down, down, down};
    std::array<Hit, 3> hits;
    tracer.test(nodes, rays, hits);
    ASSERT_EQ(log.rays().size(), 1u);
    EXPECT_EQ(log.rays()[0].node, 0u);
}

TEST(RayLog, IsWrittenAsJsonWithNamesAndNulls) {
    const Scene scene = mirror_and_ceiling();
    const std::string tree = ray_log_json(logged(scene, {{4, 2.9, 0}, {0, 1, 0}}), scene).text();
    for (const char* part :
         {"\"parent\": null", "\"parent\": 0", "\"kind\": \"primary\"", "\"kind\": \"shadow\"",
          "\"hit\": \"ceiling\"", "\"hit\": \"blocked\"", "\"by\": \"ball\"", "\"hit\": \"lit\""}) {
        EXPECT_NE(tree.find(part), std::string::npos) << part << "\n" << tree;
    }
    const std::string sky = ray_log_json(logged(scene, {{30, 1, 0}, {0, 1, 0}}), scene).text();
    EXPECT_NE(sky.find("\"end\": null"), std::string::npos) << sky;
    EXPECT_NE(sky.find("\"hit\": \"sky\""), std::string::npos) << sky;
}

}  // namespace
}  // namespace luch
