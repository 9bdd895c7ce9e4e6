#include "framework/technique/catalogue.h"
#include "framework/technique/stereo.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

// What run() and the classic tracer make of every camera.
namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch {
namespace {

Outcome rendered(Scene scene, int spp, int threads = 2, const Budget& budget = {}) {
    const testing::OwnStudio studio(std::move(scene), threads);
    Shot shot = shot_of(studio.scene());
    shot.spp = spp;
    return studio.render(*baseline::describe().create(), shot, budget);
}

Scene with_camera(void (*change)(Camera&)) {
    Scene scene = testing::bit_of_everything();
    change(scene.camera);
    return scene;
}

void put_lens(Camera& camera) {
    camera.depth_of_field = true;
    camera.f_number = 2;
    camera.focal_distance = 12;
    camera.lens_samples = 5;
}

TEST(Lens, IsBitIdenticalOnAnyNumberOfThreads) {
    for (const int spp : {0, 1, 3}) {
        const Outcome one = rendered(with_camera(put_lens), spp, 1);
        EXPECT_EQ(rendered(with_camera(put_lens), spp, 2).frame.colour, one.frame.colour) << spp;
        EXPECT_EQ(rendered(with_camera(put_lens), spp, 16).frame.colour, one.frame.colour) << spp;
    }
}

TEST(Lens, TakesItsOwnSamplesUnlessTheirNumberIsGiven) {
    const std::uint64_t pixels = 64 * 48;
    EXPECT_EQ(rendered(with_camera(put_lens), 0).counts.of(RayKind::primary), 5 * pixels);
    EXPECT_EQ(rendered(with_camera(put_lens), 3).counts.of(RayKind::primary), 3 * pixels);
}

TEST(Lens, IsLeftOutExactlyWhereThereIsNone) {
    const Outcome pinhole = rendered(testing::bit_of_everything(), 3);
    const Outcome forced = rendered(testing::bit_of_everything(), 3, 2, {.skip = false});
    EXPECT_FALSE(pinhole.plan.needed("lens"));
    EXPECT_TRUE(forced.plan.needed("lens"));
    EXPECT_EQ(pinhole.frame.colour, forced.frame.colour);
    EXPECT_TRUE(rendered(with_camera(put_lens), 3).plan.needed("lens"));
    EXPECT_FALSE(rendered(with_camera(put_lens), 0).plan.needed("anti-aliasing"));
}

/// A white square that fills the upper half of the view exactly, at depth 10.
Scene half_plane(double focal_distance) {
    Scene scene = testing::empty_scene();
    scene.settings.frame = {41, 41};
    scene.camera.aspect = 1;
    put_lens(scene.camera);
    scene.camera.focal_distance = focal_distance;
    scene.camera.lens_samples = 256;
    const Transform upright =
        Transform::rotation(0, -std::acos(0.0), 0).then(Transform::translation({0, 50, 10}));
    testing::add(scene, Plane{.limit = 50}, Const{.color = Rgb(1)}, upright);
    return scene;
}

TEST(Lens, BlursAnEdgeOverItsCircleOfConfusion) {
    // Depth 10, focus 20, radius 1.25: the circle's radius at the edge is 1.25·|1 − 10/20|, and a
    // pixel there is 20/41 · tan 45°/√2 wide.
    const double pixel = 2 * 10 * std::tan(std::acos(0.0) / 2) / std::sqrt(2.0) / 41;
    const double radius_px = 1.25 * 0.5 / pixel;
    const Image<Rgb> image = rendered(half_plane(20), 0).frame.colour;
    for (int y = 0; y < 41; ++y) {
        // The share of a disc on the far side of a chord.
        const double h = std::clamp((y + 0.5 - 20.5) / radius_px, -1.0, 1.0);
        const double share = (std::acos(h) - h * std::sqrt(1 - h * h)) / std::acos(-1.0);
        EXPECT_NEAR(image(20, y).r, share, 0.06) << y;
    }
}

TEST(Lens, IsSharpInItsPlaneOfFocus) {
    const Image<Rgb> image = rendered(half_plane(10), 0).frame.colour;
    for (int y = 0; y < 41; ++y) {
        if (y == 20) continue;
        EXPECT_EQ(image(20, y), Rgb(y < 20 ? 1.0f : 0.0f)) << y;
    }
}

Scene ball_ahead() {
    Scene scene = testing::empty_scene();
    scene.settings.frame = {16, 12};
    put_lens(scene.camera);
    scene.camera.auto_focus = true;
    scene.camera.yaw_deg = 20;
    const Vec3d ahead = scene.camera.to_world().direction({0, 0, 9});
    testing::add(scene, Sphere{.centre = ahead, .radius = 2}, Lambert{});
    return scene;
}

TEST(AutoFocus, IsTheFocusOnWhatTheMiddleSeesAndARayMore) {
    const Scene automatic = ball_ahead();
    Scene by_hand = automatic;
    by_hand.camera.auto_focus = false;
    by_hand.camera.focal_distance = 7;
    const Outcome a = rendered(automatic, 2), b = rendered(by_hand, 2);
    for (std::size_t i = 0; i < a.frame.colour.pixels().size(); ++i) {
        EXPECT_NEAR(a.frame.colour.pixels()[i].g, b.frame.colour.pixels()[i].g, 1e-4f);
    }
    EXPECT_EQ(a.counts.of(RayKind::primary), b.counts.of(RayKind::primary) + 1);
}

TEST(AutoFocus, LeavesTheDistanceWhereThereIsNothing) {
    Scene automatic = ball_ahead();
    automatic.camera.yaw_deg = 45;  // the ball is at the side, out of focus
    automatic.camera.focal_distance = 3;
    Scene by_hand = automatic;
    by_hand.camera.auto_focus = false;
    EXPECT_EQ(rendered(automatic, 2).frame.colour, rendered(by_hand, 2).frame.colour);
}

TEST(Fisheye, IsBlackOutsideItsDiscAndShootsNoRayThere) {
    Scene scene = testing::empty_scene();
    scene.settings.background = Rgb(0.5f);
    scene.settings.frame = {40, 30};
    scene.camera.projection = Projection::fisheye;
    const Outcome outcome = rendered(scene, 1);
    std::uint64_t bright = 0;
    for (const Rgb& pixel : outcome.frame.colour.pixels()) {
        bright += pixel == Rgb(0.5f) ? 1u : 0u;
        EXPECT_TRUE(pixel == Rgb(0.5f) || pixel == Rgb(0));
    }
    EXPECT_EQ(outcome.counts.of(RayKind::primary), bright);
    EXPECT_NEAR(double(bright), 15 * 15 * 3.14159, 20);
}

TEST(Cameras, OfEveryKindAreBitIdenticalOnAnyNumberOfThreads) {
    for (const Projection projection :
         {Projection::fisheye, Projection::spherical, Projection::orthographic}) {
        Scene scene = testing::bit_of_everything();
        scene.settings.anti_aliasing = true;
        scene.camera.projection = projection;
        scene.camera.width = 20;
        const Outcome one = rendered(scene, 0, 1);
        EXPECT_EQ(one.non_finite.count, 0u);
        EXPECT_EQ(rendered(scene, 0, 16).frame.colour, one.frame.colour);
    }
}

TEST(Anaglyph, TakesRedFromTheLeftAndTheRestFromTheRight) {
    EXPECT_EQ(anaglyph(Rgb(0.5f), Rgb(0.25f)), Rgb(0.5f, 0.25f, 0.25f));
    // Grey 0.4; three tenths of the way from it to each channel.
    const Rgb colour = anaglyph({0.8f, 0.4f, 0}, {0.8f, 0.4f, 0});
    EXPECT_NEAR(colour.r, 0.52f, 1e-6f);
    EXPECT_NEAR(colour.g, 0.4f, 1e-6f);
    EXPECT_NEAR(colour.b, 0.28f, 1e-6f);
}

TEST(StereoOutcome, NeedsAStageWhenEitherEyeDoes) {
    Outcome left, right;
    left.plan.stages = {{"a", true, Stage::exact, "left"}, {"b", false, Stage::exact, "no"}};
    right.plan.stages = {{"a", false, Stage::exact, "no"}, {"b", true, Stage::exact, "right"}};
    left.frame_ms = {1, 2, 3};
    right.frame_ms = {10, 20};
    const Outcome both = stereo_outcome(std::move(left), right);
    EXPECT_TRUE(both.plan.needed("a"));
    EXPECT_TRUE(both.plan.needed("b"));
    EXPECT_EQ(both.plan.stages[1].why, "right");
    EXPECT_EQ(both.frame_ms, (std::vector<double>{11, 22}));
}

}  // namespace
}  // namespace luch
