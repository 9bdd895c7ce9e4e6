#include "techniques/vista/vista.h"

#include "framework/technique/catalogue.h"
#include "framework/technique/context.h"
#include "techniques/vista/plan.h"
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

std::unique_ptr<Technique> vista(const std::vector<std::string>& params = {}) {
    std::unique_ptr<Technique> technique = make(reference());
    for (const std::string& param : params) set_param(*technique, param);
    return technique;
}

Outcome rendered(const OwnStudio& studio, const std::vector<std::string>& params = {},
                 const Budget& budget = {}) {
    return studio.render(*vista(params), budget);
}

/// Nothing is left out.
Budget everything() {
    Budget budget;
    budget.skip = false;
    return budget;
}

Outcome baseline_of(const OwnStudio& studio) {
    return studio.render(*baseline::describe().create());
}

std::uint64_t covered(const Outcome& outcome) {
    const auto& ids = plane_of<NodeId>(outcome, "ids").pixels();
    return ids.size() - static_cast<std::size_t>(std::count(ids.begin(), ids.end(), no_node));
}

/// Colour, ids, depths and fallbacks, to the last bit.
void expect_same_frames(const Outcome& a, const Outcome& b) {
    EXPECT_EQ(different_pixels(a, b), 0u);
    EXPECT_EQ(plane_of<NodeId>(a, "ids"), plane_of<NodeId>(b, "ids"));
    EXPECT_EQ(plane_of<float>(a, "depth"), plane_of<float>(b, "depth"));
    EXPECT_EQ(plane_of<std::uint8_t>(a, "fallbacks"), plane_of<std::uint8_t>(b, "fallbacks"));
    EXPECT_EQ(a.counts.object_tests, b.counts.object_tests);
    EXPECT_EQ(a.counts.fallbacks, b.counts.fallbacks);
}

/// A ball of triangles: what the buffer holds of a sphere, as a mesh.
Mesh ball(int n) {
    std::vector<Tri> triangles;
    tessellate(Sphere{.centre = {0.2, 0.1, 4}, .radius = 1.3}, n, triangles);
    std::vector<Vec3d> positions;
    std::vector<std::uint32_t> indices;
    for (const Tri& triangle : triangles) {
        for (const Corner& corner : triangle.corners) {
            indices.push_back(static_cast<std::uint32_t>(positions.size()));
            positions.push_back(corner.p);
        }
    }
    return testing::mesh_of(positions, indices);
}

TEST(Vista, ShowsTheSkyOfAnEmptyScene) {
    Scene scene = testing::empty_scene();
    scene.settings.background = {0.25f, 0.5f, 1};
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio);
    for (const Rgb& colour : outcome.frame.colour.pixels()) EXPECT_EQ(colour, Rgb(0.25f, 0.5f, 1));
    EXPECT_EQ(outcome.counts.all_rays() + outcome.counts.object_tests, 0u);
}

TEST(Vista, MakesTheBaselinesPictureOfAMesh) {
    Scene scene = testing::empty_scene();
    add_shape(scene, ball(12));
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio);
    EXPECT_GT(covered(outcome), 1000u);
    EXPECT_EQ(different_pixels(outcome, baseline_of(studio)), 0u);
}

TEST(Vista, MakesTheBaselinesPictureOfASingleTriangle) {
    Scene scene = testing::empty_scene();
    add_shape(scene, testing::triangle({-1.01, -1.02, 4.03}, {1.54, -0.55, 6.06}, {0.27, 1.08, 5}));
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio);
    EXPECT_GT(covered(outcome), 500u);
    EXPECT_EQ(different_pixels(outcome, baseline_of(studio)), 0u);
}

TEST(Vista, MakesTheBaselinesPictureOfAnInfinitePlane) {
    for (const double pitch : {0.0, -30.0, 5.0, -90.0}) {
        Scene scene = testing::empty_scene();
        scene.camera.pitch_deg = pitch;
        scene.camera.roll_deg = 7;
        add_shape(scene, Plane{.y = -1});
        const OwnStudio studio(std::move(scene));
        const Outcome outcome = rendered(studio);
        EXPECT_GT(covered(outcome), 5000u);
        EXPECT_EQ(different_pixels(outcome, baseline_of(studio)), 0u) << pitch;
    }
}

TEST(Vista, MakesTheBaselinesPictureFromInsideASphere) {
    Scene scene = testing::empty_scene();
    scene.lights.clear();
    scene.lights.emplace_back(PointLight{.position = {0, 1, 0}, .power = 20});
    add_shape(scene, Sphere{.centre = {0.5, 0.2, -0.3}, .radius = 3});
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio, {"segments=8"});
    EXPECT_EQ(covered(outcome), 160u * 120u);
    EXPECT_EQ(outcome.counts.fallbacks, 0u);
    EXPECT_EQ(different_pixels(outcome, baseline_of(studio)), 0u);
}

TEST(Vista, HasTheDepthsOfFlatThings) {
    Scene scene = testing::empty_scene();
    scene.camera.yaw_deg = 20;
    scene.camera.roll_deg = -10;
    add_shape(scene, Plane{.y = -1});
    add_shape(scene, Cube{.centre = {1, 0, 6}, .side = 2});
    const OwnStudio studio(std::move(scene));
    const Screen screen(studio.scene().camera, {160, 120});
    const Outcome outcome = rendered(studio, {"hidden=depth"});
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 160; ++x) {
            const Ray ray = screen.ray(x + 0.5, y + 0.5);
            const Hit hit = closest_brute(studio.scene(), ray);
            if (!hit) continue;
            const double z = screen.to_view(ray.at(hit.t)).z;
            EXPECT_NEAR(plane_of<float>(outcome, "depth")(x, y) / z, 1, 1e-3) << x << ", " << y;
        }
    }
}

TEST(Vista, PaintsTheNearOverTheFar) {
    Scene scene = testing::empty_scene();
    const NodeId near = add_shape(scene, Sphere{.centre = {0, 0, 5}});
    const NodeId far = add_shape(scene, Sphere{.centre = {0, 0, 12}, .radius = 5});
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio);
    EXPECT_EQ(plane_of<NodeId>(outcome, "ids")(80, 60), near);
    EXPECT_EQ(plane_of<NodeId>(outcome, "ids")(80, 25), far);
    EXPECT_EQ(plane_of<NodeId>(outcome, "ids"),
              plane_of<NodeId>(rendered(studio, {"hidden=depth"}), "ids"));
}

TEST(Vista, SeesTheRadiusOfANodeInPixels) {
    Scene scene = testing::empty_scene();
    add_shape(scene, Sphere{.radius = 0.5},
              Transform::scaling(Vec3d(2)).then(Transform::translation({0, 0, 10})));
    add_shape(scene, Sphere{.centre = {0, 0, 0.5}});
    add_shape(scene, Plane{.y = -1});
    const Screen screen(scene.camera, scene.settings.frame);
    // 100 pixels a unit at distance 1; the outline's rays leave at an angle whose sine is 1/10.
    EXPECT_NEAR(radius_px(scene, scene.nodes[0], screen), 100 / std::sqrt(99), 1e-4);
    EXPECT_TRUE(std::isinf(radius_px(scene, scene.nodes[1], screen)));
    EXPECT_TRUE(std::isinf(radius_px(scene, scene.nodes[2], screen)));
}

TEST(Vista, TestsOneObjectForEachCoveredPixelAndTracesOnlyItsFallbacks) {
    // Polyhedra around the spheres instead of in them: where they stick out, the sphere is missed.
    Steps steps = reference();
    steps.tessellate = [](const Geometry& geometry, int n, std::vector<Tri>& triangles) {
        Geometry larger = geometry;
        if (auto* sphere = std::get_if<Sphere>(&larger)) sphere->radius *= 1.2;
        tessellate(larger, n, triangles);
    };
    const OwnStudio studio(testing::one_of_each());
    const Outcome outcome = studio.render(*make(steps));
    EXPECT_EQ(outcome.counts.object_tests, covered(outcome));
    EXPECT_GT(outcome.counts.fallbacks, 100u);
    EXPECT_EQ(outcome.counts.of(RayKind::primary), outcome.counts.fallbacks);
    const auto& fell_back = plane_of<std::uint8_t>(outcome, "fallbacks").pixels();
    const auto marked = std::count(fell_back.begin(), fell_back.end(), 1);
    EXPECT_EQ(static_cast<std::uint64_t>(marked), outcome.counts.fallbacks);
}

TEST(Vista, TracesWhereThePredictedObjectIsMissed) {
    // The eye is in the plane of a square's edge-on neighbour: a hole in a sphere's place is found
    // by naming the wrong node.
    Scene scene = testing::empty_scene();
    const NodeId left = add_shape(scene, Sphere{.centre = {-1, 0, 5}});
    const NodeId right = add_shape(scene, Sphere{.centre = {1, 0, 5}});
    const OwnStudio studio(std::move(scene));
    const Screen screen(studio.scene().camera, {160, 120});
    Tracer tracer(studio.studio().accelerator);
    const Image<NodeId> ids({160, 120}, left);
    Image<Hit> hits({160, 120});
    Image<std::uint8_t> fell_back({160, 120}, 9);
    reference().look_up(screen, ids.view().tile(), ids.view(), tracer, hits.view(),
                        fell_back.view());
    int of_left = 0, of_right = 0;
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 160; ++x) {
            EXPECT_EQ(hits(x, y), closest_brute(studio.scene(), screen.ray(x + 0.5, y + 0.5)));
            EXPECT_EQ(fell_back(x, y), hits(x, y).node == left ? 0 : 1);
            of_left += hits(x, y).node == left;
            of_right += hits(x, y).node == right;
        }
    }
    EXPECT_GT(of_left, 100);
    EXPECT_EQ(of_left, of_right);
}

/// The first hole: an inscribed polyhedron is smaller than its sphere, and "no id" is taken for the
/// sky.
TEST(Vista, LosesSilhouettesAndLosesFewerWithMoreSegments) {
    const OwnStudio studio(testing::sixty_spheres());
    const Outcome truth = baseline_of(studio);
    const std::size_t wrong_8 =
        different_pixels(rendered(studio, {"segments=8", "hidden=depth"}), truth);
    const std::size_t wrong_32 =
        different_pixels(rendered(studio, {"segments=32", "hidden=depth"}), truth);
    EXPECT_GT(wrong_32, 0u);
    EXPECT_GT(wrong_8, 8 * wrong_32) << "16 times as many are expected: the error is O(1/n²)";
    EXPECT_LT(wrong_8, 32 * wrong_32);
}

/// The second hole: another sphere stands between a sphere's true surface and the face of its
/// polyhedron. The buffer names the other, the ray hits it, and nobody asks whether something is
/// nearer.
TEST(Vista, TakesAHitForTheNearestHit) {
    Scene scene = testing::empty_scene();
    const NodeId sphere = add_shape(scene, Sphere{.centre = {0, 0, 5}, .radius = 2}, {}, {1, 0, 0});
    // Towards (−1, 1, −1)/√3 the octahedron's face is 1.15 from the centre, the sphere 2.
    const Vec3d middle = Vec3d(0, 0, 5) + 1.6 / std::sqrt(3.0) * Vec3d(-1, 1, -1);
    const NodeId other = add_shape(scene, Sphere{.centre = middle, .radius = 0.2}, {}, {0, 1, 0});
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio, {"segments=4", "hidden=depth"});
    const Screen screen(studio.scene().camera, {160, 120});
    const Vec2d px = *screen.project(screen.to_view(middle));
    const int x = static_cast<int>(px.x), y = static_cast<int>(px.y);
    EXPECT_EQ(plane_of<NodeId>(outcome, "ids")(x, y), other);
    EXPECT_EQ(plane_of<std::uint8_t>(outcome, "fallbacks")(x, y), 0);
    EXPECT_EQ(closest_brute(studio.scene(), screen.ray(x + 0.5, y + 0.5)).node, sphere);
    EXPECT_NE(outcome.frame.colour(x, y), baseline_of(studio).frame.colour(x, y));
}

TEST(Vista, MakesTheSameFrameOnAnyNumberOfThreads) {
    // One pool after the other: while a small one lives, it may hold a larger one back.
    const auto on_threads = [](int threads, const std::string& hidden) {
        Scene scene = testing::one_of_each();
        scene.settings.frame = {640, 480};
        return rendered(OwnStudio(std::move(scene), threads), {hidden});
    };
    for (const std::string hidden : {"hidden=painter", "hidden=depth"}) {
        const Outcome outcome = on_threads(1, hidden);
        EXPECT_GT(covered(outcome), 100'000u);
        expect_same_frames(outcome, on_threads(2, hidden));
        expect_same_frames(outcome, on_threads(16, hidden));
    }
}

TEST(Vista, KeepsNothingOfTheLastFrame) {
    const OwnStudio studio(testing::one_of_each());
    const auto technique = vista();
    Shot elsewhere = shot_of(studio.scene());
    elsewhere.spp = 1;
    elsewhere.camera.yaw_deg = 40;
    elsewhere.size = {97, 61};
    studio.render(*technique, elsewhere);
    expect_same_frames(studio.render(*technique), rendered(studio));
}

TEST(Vista, DoesNotApplyWhereRaysLeaveTheEyeOrThePixelsCentres) {
    const Scene scene = testing::one_of_each();
    Shot shot = shot_of(scene);
    EXPECT_TRUE(vista()->plan(scene, shot).applies);
    shot.spp = 4;
    EXPECT_FALSE(vista()->plan(scene, shot).applies);
    EXPECT_THAT(vista()->plan(scene, shot).why, ::testing::HasSubstr("4 samples a pixel"));
    shot.spp = 1;
    shot.camera.depth_of_field = true;
    EXPECT_FALSE(vista()->plan(scene, shot).applies);
    EXPECT_THAT(vista()->plan(scene, shot).why, ::testing::HasSubstr("depth of field"));
}

/// What is left out, by name.
std::vector<std::string> left_out(const Scene& scene, const std::vector<std::string>& params = {}) {
    std::vector<std::string> names;
    for (const Stage& stage : vista(params)->plan(scene, shot_of(scene)).stages) {
        if (!stage.needed &&
            (stage.name == "lod" || stage.name == "clip" || stage.name == "sort")) {
            names.push_back(stage.name);
        }
    }
    return names;
}

TEST(Vista, DoesNotApplyToMoreTrianglesThanItsBufferShouldHold) {
    Scene scene = testing::empty_scene();
    add_shape(scene, testing::uv_sphere(65, 64, 1));  // 8192 triangles
    scene.nodes.resize(1024, scene.nodes.front());
    EXPECT_TRUE(vista()->plan(scene, shot_of(scene)).applies);
    scene.nodes.resize(1025, scene.nodes.front());
    EXPECT_THAT(vista()->plan(scene, shot_of(scene)).why,
                ::testing::StartsWith("8396800 triangles, instances counted"));
}

TEST(Vista, LeavesOutWhatASceneDoesNotNeed) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(left_out(testing::one_of_each()), Names{});
    EXPECT_EQ(left_out(testing::one_of_each(), {"hidden=depth"}), Names{"sort"});
    EXPECT_EQ(left_out(testing::one_of_each(), {"segments=16"}), Names{"lod"});
    EXPECT_EQ(left_out(testing::one_triangle()), (Names{"lod", "clip", "sort"}));
    Scene crossing = testing::one_triangle();
    crossing.camera.yaw_deg = 45;
    EXPECT_EQ(left_out(crossing), (Names{"lod", "sort"}));
}

/// Steps that fail when they are called.
template <class... Arguments>
void forbidden(Arguments...) {
    throw std::logic_error("this stage was left out");
}

TEST(Vista, DoesNotCallTheStepsItLeavesOut) {
    Steps steps = reference();
    steps.lod = [](const Geometry&, float) -> int { throw std::logic_error("left out"); };
    steps.clip = forbidden;
    steps.sort = forbidden;
    const OwnStudio studio(testing::one_triangle());
    EXPECT_EQ(different_pixels(studio.render(*make(steps)), rendered(studio)), 0u);
    EXPECT_THROW(studio.render(*make(steps), everything()), std::logic_error);
}

TEST(Vista, ChangesNoBitByLeavingOut) {
    for (auto* scene : {testing::one_of_each, testing::one_triangle, testing::sixty_spheres}) {
        const OwnStudio studio(scene());
        for (const std::string segments : {"segments=0", "segments=8"}) {
            const Outcome planned = rendered(studio, {segments});
            expect_same_frames(planned, rendered(studio, {segments}, everything()));
        }
    }
}

TEST(Vista, AntialiasesAsTheBaselineDoes) {
    Scene scene = testing::empty_scene();
    scene.settings.anti_aliasing = true;
    add_shape(scene, ball(12));
    const OwnStudio studio(std::move(scene));
    const Shot shot = shot_of(studio.scene());
    const Outcome outcome = studio.render(*vista(), shot);
    EXPECT_EQ(different_pixels(outcome, studio.render(*baseline::describe().create(), shot)), 0u);
    EXPECT_GT(different_pixels(outcome, rendered(studio)), 100u);
}

TEST(Vista, HidesTheBacksOfACulledMesh) {
    int seen = 0;
    for (const double mirror : {1.0, -1.0}) {
        for (const bool turned : {false, true}) {
            Scene scene = testing::empty_scene();
            Mesh mesh = testing::triangle({-1, -1, 3}, {1, -1, 3}, {0, 1, 3});
            if (turned) std::swap(mesh.triangles[0].position[1], mesh.triangles[0].position[2]);
            mesh.cull_backfaces = true;
            const NodeId node = add_shape(scene, mesh, Transform::scaling({mirror, 1, 1}));
            add_shape(scene, Cube{.centre = {0, 0, 8}, .side = 6});
            const OwnStudio studio(std::move(scene));
            const Outcome outcome = rendered(studio);
            seen += plane_of<NodeId>(outcome, "ids")(80, 60) == node;
            EXPECT_EQ(outcome.counts.fallbacks, 0u);
            EXPECT_EQ(different_pixels(outcome, baseline_of(studio)), 0u);
        }
    }
    EXPECT_EQ(seen, 2) << "each winding once";
}

TEST(Vista, UsesAWrittenStepBesideHoles) {
    Steps steps = reference();
    steps.lod = [](const Geometry&, float) { return 4; };
    steps.tessellate = [](const Geometry&, int, std::vector<Tri>& triangles) {
        triangles.assign(5, {});  // half done
        LUCH_TODO("vista.t2");
    };
    steps.rasterise = [](std::span<const ScreenTri>, Tile tile, Hidden, ImageView<NodeId> ids,
                         ImageView<float>) {
        ids(tile.x0, tile.y0) = 0;
        LUCH_TODO("vista.t6");
    };
    const OwnStudio studio(testing::sixty_spheres());
    const Outcome outcome = studio.render(*make(steps));
    expect_same_frames(outcome, rendered(studio, {"segments=4"}));
    EXPECT_EQ(outcome.unwritten, (std::vector<std::string>{"vista.t2", "vista.t6"}));
}

}  // namespace
}  // namespace luch::techniques::vista
