#include "techniques/ldr/ldr.h"

#include "framework/measure/metrics.h"
#include "framework/technique/catalogue.h"
#include "framework/technique/context.h"
#include "techniques/ldr/plan.h"
#include "techniques/ldr/planes.h"
#include "techniques/ldr/render.h"
#include "techniques/ldr/stress.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch::techniques::ldr {
TechniqueInfo describe();
namespace {

using testing::OwnStudio;
using testing::plane_of;

Outcome rendered(const OwnStudio& studio, const std::vector<std::string>& params = {},
                 const Budget& budget = {}, int spp = 1) {
    const std::unique_ptr<Technique> technique = make(reference());
    for (const std::string& param : params) set_param(*technique, param);
    Shot shot = shot_of(studio.scene());
    shot.spp = spp;
    return studio.render(*technique, shot, budget);
}

Image<Rgb> baseline_of(const OwnStudio& studio, int spp = 1) {
    Shot shot = shot_of(studio.scene());
    shot.spp = spp;
    return studio.render(*baseline::describe().create(), shot).frame.colour;
}

/// Root of the mean squared error in linear light, what is above white being white.
double error_of(const Outcome& outcome, const Image<Rgb>& truth) {
    double sum = 0;
    for (std::size_t i = 0; i < truth.pixels().size(); ++i) {
        const Vec3d off(outcome.frame.colour.pixels()[i] - glm::min(truth.pixels()[i], 1.0f));
        sum += glm::dot(off, off) / 3;
    }
    return std::sqrt(sum / static_cast<double>(truth.pixels().size()));
}

/// The float frame quantised once, in levels of the screen: the largest distance from it, and the
/// mean of the signed ones.
struct Levels {
    int largest = 0;
    double mean = 0;
};
Levels levels_off(const Outcome& outcome, const Image<Rgb>& truth) {
    Levels off;
    for (std::size_t i = 0; i < truth.pixels().size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const int exact = byte_of(srgb_encoded(truth.pixels()[i][c]));
            const int got = byte_of(srgb_encoded(outcome.frame.colour.pixels()[i][c]));
            off.largest = std::max(off.largest, std::abs(got - exact));
            off.mean += got - exact;
        }
    }
    off.mean /= 3.0 * static_cast<double>(truth.pixels().size());
    return off;
}

/// Sixty spheres in dim light: nothing above white.
Scene dim() {
    Scene scene = testing::sixty_spheres();
    scene.settings.ambient_light = Rgb(0.1f, 0.15f, 0.2f);
    scene.settings.background = Rgb(0.3f, 0.4f, 0.6f);
    for (Light& light : scene.lights) std::get<PointLight>(light).power *= 0.3f;
    return scene;
}

/// A white floor under suns that shine straight down, seen from above.
Scene under_suns(int suns, float power) {
    Scene scene = testing::empty_scene();
    scene.camera.pitch_deg = -90;
    scene.lights.assign(static_cast<std::size_t>(suns), DirectionalLight{.power = power});
    scene.settings.ambient_light = Rgb(0);
    testing::add_shape(scene, Plane{.y = -1}, {}, Rgb(0.2f));
    return scene;
}

float middle_of(const Outcome& outcome) {
    return outcome.frame.colour(80, 60).g;
}

TEST(Ldr, IsTheFloatFrameQuantisedOnceToALevel) {
    const OwnStudio studio(dim());
    const Levels off = levels_off(rendered(studio, {"dither=off"}), baseline_of(studio));
    EXPECT_LE(off.largest, 2);
    EXPECT_LT(std::abs(off.mean), 0.1);
}

TEST(Ldr, ShowsEveryKindOfThingAsTheBaselineDoes) {
    const OwnStudio studio(testing::bit_of_everything());
    EXPECT_LT(error_of(rendered(studio), baseline_of(studio)), 0.006);
}

TEST(Ldr, LosesLightsOfLessThanHalfALevelInWordsAlone) {
    const OwnStudio studio(under_suns(100, 0.45f / 255));
    EXPECT_EQ(middle_of(rendered(studio, {"wide=off"})), 0);
    EXPECT_NEAR(middle_of(rendered(studio)), 0.2 * 45 / 255, 0.002);
}

TEST(Ldr, ClipsABrightLightInWordsAlone) {
    const OwnStudio studio(under_suns(1, 3));
    EXPECT_NEAR(middle_of(rendered(studio, {"wide=off"})), 0.2, 0.005) << "white times 0.2";
    EXPECT_NEAR(middle_of(rendered(studio)), 0.6, 0.005);
}

TEST(Ldr, LosesTheMeanOfManySamplesInWordsAlone) {
    Scene scene = testing::empty_scene();
    scene.settings.background = Rgb(0.05f);
    const OwnStudio studio(std::move(scene));
    const auto off = [&](const char* wide) {
        return std::abs(middle_of(rendered(studio, {wide, "dither=off"}, {}, 64)) - 0.05f);
    };
    EXPECT_NEAR(off("wide=off"), 0.05f, 1e-6) << "4/255 of 13 levels is none";
    EXPECT_LT(off("wide=on"), 0.003f);
}

TEST(Ldr, MixesTwoSamplesWithoutBiasInWordsAlone) {
    const OwnStudio studio(dim());
    const Outcome words = rendered(studio, {"wide=off", "dither=off"}, {}, 2);
    const Outcome wide = rendered(studio, {"dither=off"}, {}, 2);
    double bias = 0;
    for (std::size_t i = 0; i < words.frame.colour.pixels().size(); ++i) {
        bias += words.frame.colour.pixels()[i].g - wide.frame.colour.pixels()[i].g;
    }
    EXPECT_LT(std::abs(bias) / static_cast<double>(words.frame.colour.pixels().size()), 0.5 / 255);
}

/// The slope of the error over the number of levels, in log-log: a rounding's is q/√12.
TEST(Ldr, ErrsInProportionToTheWidthOfALevel) {
    const OwnStudio studio(dim());
    const Image<Rgb> truth = baseline_of(studio);
    for (const char* wide : {"wide=on", "wide=off"}) {
        double n = 0, x = 0, y = 0, xx = 0, xy = 0;
        for (int bits = 4; bits <= 16; bits += 2) {
            const auto levels = "levels=" + std::to_string(1 << bits);
            const double error =
                std::log2(error_of(rendered(studio, {levels, wide, "dither=off"}), truth));
            ++n;
            x += bits;
            y += error;
            xx += double(bits) * bits;
            xy += bits * error;
        }
        EXPECT_NEAR((n * xy - x * y) / (n * xx - x * x), -1, 0.1) << wide;
    }
}

/// A frame by one of the canvases.
template <class Canvas>
Image<Rgb> drawn(const OwnStudio& studio, bool gathers) {
    Shot shot = shot_of(studio.scene());
    shot.spp = 1;
    const Steps steps = reference();
    const Plan plan = plan_of(studio.scene(), shot, {});
    Context context(studio.studio().accelerator, studio.studio().workers, plan, {});
    Frame frame(shot.size);
    make_planes(frame);
    Renderer<Canvas>({.scene = studio.scene(),
                      .shot = shot,
                      .frame = frame,
                      .context = context,
                      .look = {.steps = &steps,
                               .reference = &steps,
                               .context = &context,
                               .ambient = studio.scene().settings.ambient_light,
                               .gathers = gathers},
                      .dither = false})
        .render();
    return frame.colour;
}

std::size_t levels_apart(const Image<Rgb>& a, const Image<Rgb>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            count +=
                byte_of(srgb_encoded(a.pixels()[i][c])) != byte_of(srgb_encoded(b.pixels()[i][c]));
        }
    }
    return count;
}

/// What is worked out for any number of levels is, for 256, what words give.
TEST(Ldr, WorksOutOtherLevelsAsWordsWouldHaveThem) {
    const OwnStudio studio(dim());
    EXPECT_EQ(levels_apart(drawn<LevelCanvas>(studio, false), drawn<WordCanvas>(studio, false)),
              0u);
    EXPECT_LT(levels_apart(drawn<LevelCanvas>(studio, true), drawn<WideCanvas>(studio, true)),
              160 * 120 * 3 / 200);
}

TEST(Ldr, CountsAndShowsWhatIsNoNumber) {
    Scene scene = testing::one_triangle();
    scene.settings.background = Rgb(std::numeric_limits<float>::quiet_NaN(), 0, 0);
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio);
    const auto& coverage = plane_of<float>(outcome, "coverage").pixels();
    const auto sky = static_cast<std::uint64_t>(std::ranges::count(coverage, 0.0f));
    EXPECT_GT(sky, 1000u);
    EXPECT_LT(sky, coverage.size());
    EXPECT_EQ(outcome.non_finite.count, sky);
}

TEST(Ldr, HasCoverageInItsFourthChannel) {
    const OwnStudio studio(testing::one_triangle());
    for (const int spp : {1, 16}) {
        const Outcome outcome = rendered(studio, {}, {}, spp);
        int none = 0, all = 0, part = 0;
        for (const float alpha : plane_of<float>(outcome, "coverage").pixels()) {
            ++(alpha == 0 ? none : alpha == 1 ? all : part);
        }
        EXPECT_GT(none, 100);
        EXPECT_GT(all, 100);
        EXPECT_EQ(part > 0, spp > 1) << "rims are covered in part";
    }
}

TEST(Ldr, TakesTheScenesOwnAntiAliasing) {
    Scene scene = dim();
    scene.settings.anti_aliasing = true;
    const OwnStudio studio(std::move(scene));
    const Image<Rgb> smooth = baseline_of(studio, 0);
    EXPECT_LT(error_of(rendered(studio, {}, {}, 0), smooth), 0.01);
    EXPECT_GT(error_of(rendered(studio, {}, {}, 1), smooth), 0.015);
    EXPECT_LT(error_of(rendered(studio, {"wide=off"}, {}, 0), smooth), 0.02);
}

TEST(Ldr, MultipliesLightByItsExposure) {
    const OwnStudio studio(under_suns(1, 3));
    EXPECT_NEAR(middle_of(rendered(studio, {"exposure=-2"})), 0.15, 0.005);
    EXPECT_NEAR(middle_of(rendered(studio, {"exposure=-2", "wide=off"})), 0.15, 0.005);
}

TEST(LdrPlan, LeavesOutTheAccumulatorOfOneSampleExactly) {
    Scene scene = testing::empty_scene();
    scene.settings.background = Rgb(0.2f, 0.5f, 0.9f);
    testing::add(scene, Sphere{.centre = {0, 0, 3}}, Const{.color = {0.1f, 0.01f, 0.7f}});
    const OwnStudio studio(std::move(scene));
    const Outcome lean = rendered(studio);
    EXPECT_FALSE(lean.plan.needed("accumulator"));
    const Outcome full = rendered(studio, {}, {.forced = {"accumulator"}});
    EXPECT_EQ(testing::different_pixels(lean, full), 0u);
    EXPECT_TRUE(rendered(studio, {}, {}, 2).plan.needed("accumulator"));
}

TEST(LdrPlan, LeavesOutWideLightWithinItsBound) {
    Scene scene = testing::empty_scene();
    scene.settings.background = Rgb(0.2f, 0.501f, 0.9f);
    for (int i = 0; i < 40; ++i) {
        testing::add(scene, Sphere{.centre = {i * 0.2 - 4, i % 7 * 0.3 - 1, 3}, .radius = 0.2},
                     Const{.color = Rgb(static_cast<float>(i) / 40)});
    }
    const OwnStudio studio(std::move(scene));
    const Outcome lean = rendered(studio);
    ASSERT_FALSE(lean.plan.needed("wide light"));
    const Outcome full = rendered(studio, {}, {.forced = {"wide light"}});
    const Image<Rgb>&a = lean.frame.colour, &b = full.frame.colour;
    float most = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        most = std::max(most, max_norm(a.pixels()[i] - b.pixels()[i]));
    }
    EXPECT_GT(most, 0);
    for (const Stage& stage : lean.plan.stages) {
        if (stage.name != "wide light") continue;
        EXPECT_EQ(stage.kind, Stage::bounded);
        EXPECT_LE(most, stage.bound);
    }
    EXPECT_TRUE(rendered(OwnStudio(dim())).plan.needed("wide light"));
}

TEST(LdrPlan, LeavesOutToneMappingExactlyWhereNothingIsAboveWhite) {
    Scene scene = testing::empty_scene();
    scene.lights.clear();
    scene.settings.background = Rgb(0.5f, 0.9f, 1);
    testing::add(scene, Sphere{.centre = {0, 0, 3}}, Const{.color = {0.1f, 0.01f, 0.7f}});
    const OwnStudio studio(std::move(scene));
    const Outcome lean = rendered(studio, {"tone=reinhard"});
    EXPECT_FALSE(lean.plan.needed("tone mapping"));
    const Outcome full = rendered(studio, {"tone=reinhard"}, {.forced = {"tone mapping"}});
    EXPECT_EQ(testing::different_pixels(lean, full), 0u);
}

TEST(LdrPlan, MapsTonesWhereSomethingIsAboveWhite) {
    const OwnStudio studio(under_suns(1, 20));
    const Outcome clamped = rendered(studio), toned = rendered(studio, {"tone=reinhard"});
    EXPECT_TRUE(toned.plan.needed("tone mapping"));
    EXPECT_EQ(middle_of(clamped), 1);
    EXPECT_EQ(middle_of(toned), 1) << "the brightest is white";
    const OwnStudio spheres(testing::sixty_spheres());
    const auto white = [](const Outcome& outcome) {
        return std::ranges::count_if(outcome.frame.colour.pixels(),
                                     [](const Rgb& pixel) { return max_norm(pixel) >= 1; });
    };
    EXPECT_GT(white(rendered(spheres, {"exposure=4"})),
              10 * white(rendered(spheres, {"exposure=4", "tone=reinhard"})));
}

TEST(LdrPlan, TakesBitmapsInWordsToTheLastBit) {
    Scene scene = testing::empty_scene();
    scene.settings.ambient_light = Rgb(0.5f);
    Image<Rgb> picture({16, 16});
    for (std::size_t i = 0; i < 256; ++i) {
        const auto level = static_cast<float>(i) / 255;
        picture.pixels()[i] = srgb_decoded(Rgb(level, 1 - level, 0.5f));
    }
    scene.textures.emplace_back(BitmapTexture{picture, 2});
    testing::add(scene, Plane{.y = -1}, Lambert{.texture = 0});
    const OwnStudio studio(std::move(scene));
    const Outcome words = rendered(studio), floats = rendered(studio, {"textures=off"});
    EXPECT_TRUE(words.plan.needed("word textures"));
    EXPECT_EQ(testing::different_pixels(words, floats), 0u);
    const Image<Rgb> truth = baseline_of(studio);
    EXPECT_LE(levels_off(words, truth).largest, 2);
}

TEST(LdrStress, HasNoFailureOfItsOwn) {
    const TechniqueInfo info = describe();
    for (const StressCase& each : stress_cases(info, false)) {
        const StressResult result = each.run();
        EXPECT_EQ(result.verdict, StressVerdict::pass) << each.name << ": " << result.got;
    }
}

}  // namespace
}  // namespace luch::techniques::ldr
