#include "techniques/vista/exact.h"

#include "framework/technique/catalogue.h"
#include "techniques/vista/vista.h"
#include "tests/testing/everything.h"
#include "tests/testing/meshes.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch::techniques::vista {
namespace {

using testing::add_shape;
using testing::different_pixels;
using testing::OwnStudio;
using testing::plane_of;

std::unique_ptr<Technique> exact(const std::vector<std::string>& params = {}) {
    std::unique_ptr<Technique> technique = make(reference(), Mode::exact);
    for (const std::string& param : params) set_param(*technique, param);
    return technique;
}

/// With the buffer, whether it pays or not.
Outcome rendered(const OwnStudio& studio, const std::vector<std::string>& params = {},
                 const Budget& budget = {.forced = {"item buffer"}}) {
    return studio.render(*exact(params), budget);
}

void expect_the_baselines_picture(const OwnStudio& studio, const Outcome& outcome) {
    const Outcome truth = studio.render(*baseline::describe().create());
    EXPECT_EQ(different_pixels(outcome, truth), 0u);
}

/// Planes of the frame against the oracle.
void expect_true_planes(const OwnStudio& studio, const Outcome& outcome) {
    const Screen screen(studio.scene().camera, outcome.frame.size());
    const auto& ids = plane_of<NodeId>(outcome, "ids");
    const auto& triangles = plane_of<std::uint32_t>(outcome, "triangles");
    for (int y = 0; y < ids.height(); ++y) {
        for (int x = 0; x < ids.width(); ++x) {
            const Hit hit = closest_brute(studio.scene(), screen.ray(x + 0.5, y + 0.5));
            ASSERT_EQ(ids(x, y), hit.node) << x << ", " << y;
            if (triangles(x, y) == no_node) continue;
            ASSERT_EQ(triangles(x, y), hit.primitive);
        }
    }
}

TEST(VistaExact, MakesTheBaselinesPictureBitForBit) {
    for (auto* scene : {testing::one_of_each, testing::one_triangle, testing::sixty_spheres,
                        testing::bit_of_everything, testing::empty_scene}) {
        const OwnStudio studio(scene());
        const Outcome outcome = rendered(studio);
        expect_the_baselines_picture(studio, outcome);
        expect_true_planes(studio, outcome);
    }
}

TEST(VistaExact, FallsBackInLessThanAHundredthOfTheFrame) {
    for (auto* scene : {testing::one_of_each, testing::sixty_spheres}) {
        const OwnStudio studio(scene());
        const Outcome outcome = rendered(studio);
        EXPECT_LT(outcome.counts.fallbacks, 160u * 120u / 100);
        EXPECT_EQ(outcome.counts.of(RayKind::primary), outcome.counts.fallbacks);
        const auto& fell_back = plane_of<std::uint8_t>(outcome, "fallbacks").pixels();
        EXPECT_EQ(std::count(fell_back.begin(), fell_back.end(), 1),
                  static_cast<std::ptrdiff_t>(outcome.counts.fallbacks));
    }
}

TEST(VistaExact, NeedsAboutOneObjectTestForEachPixelThatASphereCovers) {
    const OwnStudio studio(testing::sixty_spheres());
    const Outcome outcome = rendered(studio);
    const auto& ids = plane_of<NodeId>(outcome, "ids").pixels();
    const auto covered =
        ids.size() - static_cast<std::size_t>(std::count(ids.begin(), ids.end(), no_node));
    EXPECT_GT(outcome.counts.object_tests, covered / 2);
    EXPECT_LT(outcome.counts.object_tests, covered * 5 / 4);
}

TEST(VistaExact, IsExactWithPolyhedraOfAnyNumberOfSegments) {
    const OwnStudio studio(testing::sixty_spheres());
    std::vector<std::uint64_t> tests;
    for (const int segments : {1, 5, 8, 33, 128}) {
        const Outcome outcome = rendered(studio, {"segments=" + std::to_string(segments)});
        expect_the_baselines_picture(studio, outcome);
        tests.push_back(outcome.counts.object_tests);
    }
    EXPECT_LT(tests.back(), tests.front()) << "a round hull is missed less";
}

/// A crowd: more spheres in a pixel than are tested one by one.
TEST(VistaExact, TracesWhereTooManyMayBeInFront) {
    Scene scene = testing::empty_scene();
    for (int i = 0; i < 30; ++i) {
        add_shape(scene, Sphere{.centre = {0.003 * i, 0.002 * (i % 7), 5 + 0.001 * (i % 5)}});
    }
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio);
    EXPECT_GT(outcome.counts.fallbacks, 100u);
    expect_the_baselines_picture(studio, outcome);
}

/// A shape, where it stands, and where the eye is.
struct Odd {
    std::string name;
    Geometry geometry;
    Transform to_world;
    Vec3d eye;
};

std::vector<Odd> odd_ones() {
    const Transform squeezed =
        Transform::scaling({1, 1e-3, 1}).then(Transform::rotation(0.3, 0.4, 0.1));
    return {{"inside a sphere", Sphere{.radius = 3}, {}, {0.5, 0.2, -0.3}},
            {"between a sphere and its hull", Sphere{.radius = 3}, {}, {0, 3.0000001, 0}},
            {"just beside a sphere", Sphere{.radius = 3}, {}, {0, 1, -3}},
            {"tiny and far away", Sphere{.radius = 1e-3}, {}, {0, 0, -1e4}},
            {"huge", Sphere{.centre = {0, -1e6, 0}, .radius = 1e6}, {}, {0, 1, 0}},
            {"far from the origin",
             Sphere{},
             Transform::translation({1e7, 3, -1e7}),
             {1e7 + 0.5, 3, -1e7 - 4}},
            {"inside a cube", Cube{.side = 2}, {}, {0.1, 0.2, 0.3}},
            {"in a cube's side", Cube{.side = 2}, {}, {0, 0, -1}},
            {"in a square's plane", Plane{.y = 0, .limit = 2}, {}, {0, 0, -5}},
            {"above a square", Plane{.y = 0, .limit = 2}, squeezed, {0, 1, -5}},
            {"a squeezed sphere", Sphere{}, squeezed, {0, 0.5, -3}},
            {"mirrored", Sphere{.centre = {1, 0, 0}}, Transform::scaling({-1, 1, 1}), {-1, 0, -3}},
            {"an endless floor", Plane{.y = -1}, {}, {0, 0, 0}}};
}

TEST(VistaExact, IsExactFromWhereverTheEyeStands) {
    for (const Odd& odd : odd_ones()) {
        SCOPED_TRACE(odd.name);
        Scene scene = testing::empty_scene();
        scene.settings.frame = {96, 72};
        scene.camera.position = odd.eye;
        add_shape(scene, odd.geometry, odd.to_world);
        add_shape(scene, Sphere{.centre = odd.eye + Vec3d(1, 0.5, 4), .radius = 0.5});
        const OwnStudio studio(std::move(scene));
        const Outcome outcome = rendered(studio);
        expect_the_baselines_picture(studio, outcome);
        expect_true_planes(studio, outcome);
        EXPECT_LT(outcome.counts.fallbacks, 96u * 72u / 50);
    }
}

/// Every ray that meets a node has met its hull before.
TEST(VistaExact, HasHullsAroundAllThatTheyStandFor) {
    Scene scene = testing::bit_of_everything();
    const Screen screen(scene.camera, scene.settings.frame);
    Hulls hulls = hulls_of(scene, screen, 8);
    hulls.scene.materials.emplace_back(Lambert{});  // an accelerator wants whole nodes
    for (Node& node : hulls.scene.nodes) node.to_world = node.to_object.inverse();
    ASSERT_FALSE(hulls.node_of.empty());
    const auto accelerator = build_accelerator(scene);
    const auto fronts = build_accelerator(hulls.scene);
    const Size size = screen.size();
    int met = 0;
    for (std::size_t hull = 0; hull < hulls.node_of.size(); ++hull) {
        const Tile& extent = hulls.extents[hull];
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                WorkCounts work;
                const Ray ray = screen.ray(x + 0.5, y + 0.5);
                const Hit hit = accelerator->closest_in(hulls.node_of[hull], ray, work);
                if (!hit) continue;
                ++met;
                const Hit front = fronts->closest_in(static_cast<NodeId>(hull), ray, work);
                ASSERT_TRUE(front) << hull << " at " << x << ", " << y;
                ASSERT_LT(front.t, hit.t);
                ASSERT_TRUE(x >= extent.x0 && x < extent.x1 && y >= extent.y0 && y < extent.y1);
            }
        }
    }
    EXPECT_GT(met, 1000);
}

TEST(VistaExact, ShowsTheSegmentsOfThePolyhedraItUsed) {
    Scene scene = testing::empty_scene();
    add_shape(scene, Sphere{.centre = {0, 0, 4}});
    const OwnStudio studio(std::move(scene));
    EXPECT_EQ(plane_of<float>(rendered(studio, {"segments=12"}), "lod")(80, 60), 12);
    const float own = plane_of<float>(rendered(studio), "lod")(80, 60);
    EXPECT_TRUE(own >= 8 && own <= 64) << own;
    EXPECT_EQ(plane_of<float>(rendered(studio), "lod")(2, 2), 0);
}

const Stage& stage_of(const Plan& plan, std::string_view name) {
    const auto stage = std::ranges::find(plan.stages, name, &Stage::name);
    if (stage == plan.stages.end()) throw std::out_of_range("no such stage");
    return *stage;
}

TEST(VistaExact, SaysWhenItDoesNotPayAndTracesThen) {
    Scene scene = testing::empty_scene();
    scene.settings.frame = {32, 24};
    add_shape(scene, testing::uv_sphere(65, 64, 1), Transform::translation({0, 0, 3}));
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio, {}, {});
    EXPECT_FALSE(stage_of(outcome.plan, "item buffer").needed);
    EXPECT_THAT(outcome.plan.why, ::testing::StartsWith("does not pay: 11 triangles a pixel"));
    EXPECT_EQ(outcome.counts.of(RayKind::primary), 32u * 24u);
    const Outcome forced = rendered(studio);
    EXPECT_LT(forced.counts.of(RayKind::primary), 32u * 24u);
    EXPECT_EQ(different_pixels(outcome, forced), 0u);
}

TEST(VistaExact, DoesNotPayWhereNodesAreNoMeshes) {
    const OwnStudio studio(testing::sixty_spheres());
    const Plan plan = exact()->plan(studio.scene(), shot_of(studio.scene()));
    EXPECT_FALSE(stage_of(plan, "item buffer").needed);
    EXPECT_THAT(plan.why, ::testing::HasSubstr("60 nodes are no meshes"));
}

/// The lecture's bound. Around the eye all is wall, and each point of it asks for its light.
TEST(VistaExact, SavesNoMoreThanHalfOfTheRaysInAClosedScene) {
    Scene scene = testing::empty_scene();
    add_shape(scene, Cube{.side = 10});
    add_shape(scene, Sphere{.centre = {1, 1, 3}, .radius = 0.5});
    scene.lights.emplace_back(PointLight{.position = {0, 2, 0}});
    const OwnStudio studio(std::move(scene));
    const Outcome truth = studio.render(*baseline::describe().create());
    const Outcome outcome = rendered(studio);
    const std::uint64_t pixels = outcome.frame.size().area();
    EXPECT_EQ(truth.counts.of(RayKind::primary), pixels);
    EXPECT_EQ(outcome.counts.of(RayKind::shadow), truth.counts.of(RayKind::shadow));
    const std::uint64_t saved = truth.counts.all_rays() - outcome.counts.all_rays();
    EXPECT_GT(saved, pixels * 9 / 10);
    EXPECT_LE(static_cast<double>(saved), 0.505 * static_cast<double>(truth.counts.all_rays()))
        << "only the sphere's dark side needs no shadow rays";
}

TEST(VistaExact, LeavesOutStandInsWhereAllIsMadeOfTriangles) {
    const OwnStudio studio(testing::one_triangle());
    const Outcome outcome = rendered(studio);
    EXPECT_FALSE(stage_of(outcome.plan, "stand-ins").needed);
    EXPECT_FALSE(stage_of(outcome.plan, "lod").needed);
    EXPECT_TRUE(stage_of(outcome.plan, "item buffer").needed);
}

TEST(VistaExact, TestsEveryNodeInEveryPixelWithoutStandIns) {
    const OwnStudio studio(testing::sixty_spheres());
    Tracer tracer(studio.studio().accelerator);
    Context context(studio.studio().accelerator, studio.studio().workers, {}, {});
    ExactBuffer buffer;
    buffer.prepare(studio.scene());
    buffer.draw(shot_of(studio.scene()), 0, false, context);
    EXPECT_TRUE(buffer.hulls().node_of.empty());
    EXPECT_EQ(buffer.hulls().boundless.size(), 60u);
}

TEST(VistaExact, CountsTheWorkOfItsStages) {
    const OwnStudio studio(testing::sixty_spheres());
    const Outcome outcome = rendered(studio);
    const Stage& stand_ins = stage_of(outcome.plan, "stand-ins");
    EXPECT_EQ(stand_ins.work, 60u);
    EXPECT_EQ(stand_ins.worked_on, "hulls");
    EXPECT_EQ(stage_of(outcome.plan, "item buffer").worked_on, "pixels");
    EXPECT_EQ(stage_of(outcome.plan, "item buffer").work, 160u * 120u - outcome.counts.fallbacks);
}

TEST(VistaExact, AntialiasesAsTheBaselineDoes) {
    Scene scene = testing::one_of_each();
    scene.settings.anti_aliasing = true;
    const OwnStudio studio(std::move(scene));
    const Shot shot = shot_of(studio.scene());
    const Outcome outcome = studio.render(*exact(), shot);
    EXPECT_EQ(different_pixels(outcome, studio.render(*baseline::describe().create(), shot)), 0u);
}

}  // namespace
}  // namespace luch::techniques::vista
