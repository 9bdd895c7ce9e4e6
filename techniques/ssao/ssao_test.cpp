// Whole pictures.
#include "techniques/ssao/ssao.h"

#include "framework/technique/catalogue.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch::techniques::ssao {
namespace {

using testing::different_pixels;
using testing::OwnStudio;
using testing::plane_of;

constexpr const char* modes[] = {"mode=bitmask", "mode=gtao", "mode=classic", "mode=rays"};
constexpr const char* screen_modes[] = {"mode=bitmask", "mode=gtao", "mode=classic"};

/// Balls on a floor before a wall, all of it in ambient light; white, so that the picture is what
/// arrives.
Scene still_life(const Rgb& ambient = Rgb(1)) {
    Scene scene = testing::empty_scene();
    scene.lights.clear();
    scene.settings.ambient_light = ambient;
    scene.camera.position = {0, 2, -6};
    scene.camera.pitch_deg = -15;
    scene.camera.fov_deg = 70;
    testing::add_shape(scene, Plane{.limit = 30}, {}, Rgb(1));
    testing::add_shape(scene, Cube{.centre = {0, 3, 4}, .side = 6}, {}, Rgb(1));
    testing::add_shape(scene, Sphere{.centre = {-1.2, 0.8, 0}, .radius = 0.8}, {}, Rgb(1));
    testing::add_shape(scene, Sphere{.centre = {0.8, 0.5, -1}, .radius = 0.5}, {}, Rgb(1));
    testing::add_shape(scene, Cube{.centre = {2, 0.6, 0.2}, .side = 1.2}, {}, Rgb(1));
    return scene;
}

Outcome rendered(const OwnStudio& studio, const std::vector<std::string>& params,
                 const std::optional<Shot>& shot = {}) {
    const std::unique_ptr<Technique> technique = make(reference(), {.samples = 36});
    for (const std::string& param : params) set_param(*technique, param);
    return studio.render(
        *technique, shot ? *shot : [&] {
            Shot one = shot_of(studio.scene());
            one.spp = 1;
            return one;
        }());
}

Outcome baseline_of(const OwnStudio& studio) {
    return studio.render(*baseline::describe().create());
}

TEST(Ssao, MultipliesAmbientLightByWhatIsVisible) {
    const OwnStudio studio(still_life({0.5f, 0.25f, 1}));
    for (const char* mode : modes) {
        const Outcome outcome = rendered(studio, {mode, "radius=1"});
        const auto& visibility = plane_of<float>(outcome, "visibility");
        float least = 1;
        for (std::size_t i = 0; i < visibility.pixels().size(); ++i) {
            const float visible = visibility.pixels()[i];
            least = std::min(least, visible);
            const Rgb expected = visible * studio.scene().settings.ambient_light;
            const Rgb& got = outcome.frame.colour.pixels()[i];
            EXPECT_TRUE(got == Rgb(0) || max_norm(got - expected) < 1e-6f) << mode;
        }
        EXPECT_LT(least, 0.6f) << mode;
    }
}

TEST(Ssao, TakesNothingFromDirectLight) {
    Scene lit = still_life(Rgb(0.5f)), dark = still_life(Rgb(0.5f)), direct = still_life(Rgb(0));
    for (Scene* scene : {&lit, &direct}) {
        scene->lights.emplace_back(PointLight{.position = {-3, 6, -5}, .power = 90});
    }
    const OwnStudio with(std::move(lit)), ambient(std::move(dark)), light(std::move(direct));
    for (const char* mode : modes) {
        const Outcome both = rendered(with, {mode, "radius=1"}),
                      soft = rendered(ambient, {mode, "radius=1"}), hard = baseline_of(light);
        for (std::size_t i = 0; i < both.frame.colour.pixels().size(); ++i) {
            const Rgb sum = soft.frame.colour.pixels()[i] + hard.frame.colour.pixels()[i];
            EXPECT_LT(max_norm(both.frame.colour.pixels()[i] - sum), 1e-5f) << mode;
        }
    }
}

TEST(Ssao, LeavesToMirrorsTheAmbientLightOfTheScene) {
    Scene scene = still_life();
    scene.materials[0] = Reflection{};
    const OwnStudio studio(std::move(scene));
    const Outcome plain = baseline_of(studio);
    for (const char* mode : modes) {
        const Outcome outcome = rendered(studio, {mode, "radius=1"});
        EXPECT_EQ(outcome.frame.colour(80, 118), plain.frame.colour(80, 118)) << mode;
        EXPECT_GT(different_pixels(outcome, plain), 100u) << mode;
    }
}

TEST(Ssao, GivesTheSameBitsOnAnyNumberOfThreads) {
    const OwnStudio one(still_life(), 1), three(still_life(), 3);
    for (const char* mode : modes) {
        for (const char* half : {"half=off", "half=on"}) {
            const Outcome a = rendered(one, {mode, half}), b = rendered(three, {mode, half});
            EXPECT_EQ(a.frame.colour, b.frame.colour) << mode;
            EXPECT_EQ(plane_of<float>(a, "visibility"), plane_of<float>(b, "visibility"));
        }
    }
}

TEST(Ssao, ShootsNoRayMoreThanTheBaselineAndTheTruthDoes) {
    const OwnStudio studio(still_life());
    const Counts plain = baseline_of(studio).counts;
    for (const char* mode : screen_modes) {
        for (const char* radius : {"radius=0.3", "radius=1e6"}) {
            const Counts counts = rendered(studio, {mode, radius}).counts;
            EXPECT_EQ(counts.rays, plain.rays) << mode;
        }
    }
    const Counts truth = rendered(studio, {"mode=rays", "samples=10"}).counts;
    EXPECT_EQ(truth.of(RayKind::gi), 10 * truth.shades);
}

TEST(Ssao, ShowsEveryPass) {
    const OwnStudio studio(still_life());
    const Outcome outcome = rendered(studio, {"radius=1"});
    for (const char* name : {"depth", "raw occlusion", "blurred occlusion", "visibility"}) {
        EXPECT_EQ(plane_of<float>(outcome, name).size(), (Size{160, 120})) << name;
    }
    const auto& position = plane_of<Rgb>(outcome, "position");
    const auto& normal = plane_of<Rgb>(outcome, "normal");
    EXPECT_FLOAT_EQ(position(70, 100).z, plane_of<float>(outcome, "depth")(70, 100));
    EXPECT_NEAR(glm::length(normal(70, 100)), 1, 1e-6);
    EXPECT_NEAR(normal(80, 119).y, std::cos(15 * 3.14159265 / 180), 1e-5);
    const auto& raw = plane_of<float>(outcome, "raw occlusion");
    const auto& soft = plane_of<float>(outcome, "blurred occlusion");
    const auto& visible = plane_of<float>(outcome, "visibility");
    EXPECT_NE(raw, soft);
    EXPECT_EQ(visible(70, 100), 1 - soft(70, 100));
}

TEST(Ssao, CanShowWhatIsVisibleAlone) {
    Scene scene = still_life(Rgb(0));
    scene.lights.emplace_back(PointLight{.position = {-3, 6, -5}, .power = 90});
    const OwnStudio studio(std::move(scene));
    for (const char* mode : modes) {
        const Outcome outcome = rendered(studio, {mode, "radius=1", "show=visibility"});
        const auto& visibility = plane_of<float>(outcome, "visibility");
        EXPECT_LT(*std::ranges::min_element(visibility.pixels()), 0.7f) << mode;
        EXPECT_EQ(outcome.frame.colour(70, 100), Rgb(visibility(70, 100))) << mode;
        EXPECT_EQ(outcome.counts.of(RayKind::shadow), 0u);
    }
}

TEST(Ssao, DrawsNoHaloAroundAnEdgeFarInFront) {
    Scene scene = testing::empty_scene();
    scene.lights.clear();
    scene.settings.ambient_light = Rgb(1);
    // A box 100 in front of a wall.
    testing::add_shape(scene, Cube{.centre = {0, 0, 310}, .side = 400}, {}, Rgb(1));
    testing::add_shape(scene, Cube{.centre = {3, 0, 12.5}, .side = 5}, {}, Rgb(1));
    const OwnStudio studio(std::move(scene));
    for (const char* mode : modes) {
        for (const char* blur : {"blur=edges", "blur=gaussian"}) {
            const Outcome outcome = rendered(studio, {mode, blur, "radius=5"});
            for (const float visible : plane_of<float>(outcome, "visibility").pixels()) {
                ASSERT_GT(visible, 0.999f) << mode;
            }
        }
    }
}

TEST(Ssao, LooksUpWhatIsVisibleForSamplesBesideACentre) {
    const OwnStudio studio(still_life());
    Shot shot = shot_of(studio.scene());
    shot.spp = 16;
    const Outcome truth = rendered(studio, {"mode=rays", "radius=1"}, shot);
    const Outcome outcome = rendered(studio, {"radius=1"}, shot);
    double off = 0;
    for (std::size_t i = 0; i < truth.frame.colour.pixels().size(); ++i) {
        off += std::abs(truth.frame.colour.pixels()[i].r - outcome.frame.colour.pixels()[i].r);
    }
    EXPECT_LT(off / static_cast<double>(truth.frame.colour.pixels().size()), 0.03);
}

TEST(Ssao, IsAntiAliasedAsTheSceneAsks) {
    Scene scene = still_life();
    scene.settings.anti_aliasing = true;
    const OwnStudio studio(std::move(scene));
    for (const char* mode : modes) {
        const Outcome plain = rendered(studio, {mode, "radius=1"});
        const Outcome smooth = rendered(studio, {mode, "radius=1"}, shot_of(studio.scene()));
        EXPECT_GT(smooth.counts.of(RayKind::primary), plain.counts.of(RayKind::primary)) << mode;
        const std::size_t changed = different_pixels(plain, smooth);
        EXPECT_GT(changed, 50u) << mode;
        EXPECT_LT(changed, 6000u) << mode;
    }
}

/// A step that a student has still to write.
void no_occlusion(const GBuffer&, const Screen&, std::span<const Vec3>, const Params&, Key, Tile,
                  ImageView<float>) {
    LUCH_TODO("ssao.t4");
}

TEST(Ssao, FillsAHoleWithTheReferenceAndNamesIt) {
    Steps steps = reference();
    steps.occlusion = no_occlusion;
    const OwnStudio studio(still_life());
    const Outcome outcome = studio.render(*make(steps));
    EXPECT_THAT(outcome.unwritten, ::testing::ElementsAre("ssao.t4"));
    EXPECT_EQ(outcome.frame.colour,
              rendered(studio, {"mode=classic", "normals=picture", "samples=0"}).frame.colour);
}

TEST(Ssao, LosesLittleAtHalfOfTheResolution) {
    const OwnStudio studio(still_life());
    const auto full = rendered(studio, {"radius=1"}),
               half = rendered(studio, {"radius=1", "half=on"});
    const auto& a = plane_of<float>(full, "visibility").pixels();
    const auto& b = plane_of<float>(half, "visibility").pixels();
    double off = 0;
    for (std::size_t i = 0; i < a.size(); ++i) off += std::abs(a[i] - b[i]);
    off /= static_cast<double>(a.size());
    EXPECT_LT(off, 0.015);
    EXPECT_GT(off, 0);
    EXPECT_EQ(half.counts.rays, full.counts.rays);
}

}  // namespace
}  // namespace luch::techniques::ssao
