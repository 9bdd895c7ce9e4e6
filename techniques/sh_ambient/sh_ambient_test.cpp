// Whole pictures, against the baseline and against the technique's own truths.
#include "techniques/sh_ambient/sh_ambient.h"

#include "framework/math/spread.h"
#include "framework/technique/catalogue.h"
#include "framework/trace/directions.h"
#include "framework/trace/path.h"
#include "techniques/sh_ambient/incoming.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch::techniques::sh_ambient {
namespace {

using testing::different_pixels;
using testing::OwnStudio;

constexpr Size small{48, 36};

Params with(Mode mode) {
    return {.mode = static_cast<int>(mode), .samples = 64, .probes = 4, .rays = 32, .bounces = 1};
}
constexpr std::array modes{Mode::environment, Mode::probes, Mode::sampled, Mode::traced};

/// A sky that is brighter above and to one side.
CubemapEnvironment slanted_sky() {
    CubemapEnvironment sky;
    for (std::size_t i = 0; i < 6; ++i) {
        sky.sides[i] = Image<Rgb>({2, 2}, Rgb(0.1f * static_cast<float>(i + 1), 0.3f, 0.5f));
    }
    return sky;
}

/// Spheres under it.
Scene outside() {
    Scene scene = testing::sixty_spheres();
    scene.settings.frame = small;
    scene.environment = slanted_sky();
    return scene;
}

Outcome rendered(const Scene& scene, const Params& params, int threads = 2,
                 const Budget& budget = {}) {
    const OwnStudio studio(scene, threads);
    return studio.render(*make(reference(), params), budget);
}

Outcome baseline_of(const Scene& scene) {
    return OwnStudio(scene).render(*luch::baseline::describe().create());
}

double most_apart(const Outcome& a, const Outcome& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.frame.colour.pixels().size(); ++i) {
        most = std::max<double>(most,
                                max_norm(a.frame.colour.pixels()[i] - b.frame.colour.pixels()[i]));
    }
    return most;
}

const Stage& stage_of(const Outcome& outcome, std::string_view name) {
    return *std::ranges::find(outcome.plan.stages, name, &Stage::name);
}

TEST(ShAmbient, IsTheBaselineWithAmbientLightOfAConstantSkysColour) {
    Scene scene = outside();
    const Rgb colour(0.25f, 0.5f, 0.75f);
    scene.environment = ConstantEnvironment{colour};
    Scene flat = scene;
    flat.settings.ambient_light = colour;
    const Outcome truth = baseline_of(flat);
    for (const Mode mode : {Mode::environment, Mode::sampled}) {
        EXPECT_LT(most_apart(rendered(scene, with(mode)), truth), 1e-6);
    }
    // A background is a sky, too.
    scene.environment.reset();
    scene.settings.background = colour;
    EXPECT_LT(most_apart(rendered(scene, with(Mode::environment)), truth), 1e-6);
}

TEST(ShAmbient, LightsWhatMirrorsShow) {
    // A mirror as a ceiling: what it shows is lit by the sky as what is seen at once.
    Scene scene = testing::empty_scene();
    scene.settings.frame = small;
    scene.settings.background = Rgb(0.5f);
    scene.lights.clear();
    testing::add_shape(scene, Cube{.centre = {0, 0, -8}, .side = 6}, {}, Rgb(1));
    testing::add_shape(scene, Cube{.centre = {0, 0, 20}, .side = 20});
    scene.materials.back() = Reflection{.multiplier = Rgb(1)};
    const Outcome seen = rendered(scene, with(Mode::environment));
    EXPECT_NEAR(seen.frame.colour(24, 18).x, 0.5, 1e-6);
    scene.settings.background = Rgb(0.25f);
    EXPECT_NEAR(rendered(scene, with(Mode::environment)).frame.colour(24, 18).x, 0.25, 1e-6);
}

TEST(ShAmbient, IsCloseToItsTruth) {
    const Scene scene = outside();
    Params truth = with(Mode::sampled);
    truth.samples = 1024;
    const Outcome sampled = rendered(scene, truth);
    constexpr std::array limits{0.5, 0.1, 0.01};
    double before = 1;
    for (int degree = 0; degree < 3; ++degree) {
        Params params = with(Mode::environment);
        params.degree = degree;
        const double off = most_apart(rendered(scene, params), sampled);
        EXPECT_LT(off, limits[static_cast<std::size_t>(degree)]) << degree;
        EXPECT_LT(off, 0.5 * before) << degree;
        before = off;
    }
}

TEST(ShAmbient, IsTheSameOnAnyNumberOfThreadsInEveryMode) {
    for (const Mode mode : modes) {
        const Outcome one = rendered(testing::bit_of_everything(), with(mode), 1);
        const Outcome many = rendered(testing::bit_of_everything(), with(mode), 5);
        EXPECT_EQ(different_pixels(one, many), 0u) << static_cast<int>(mode);
        EXPECT_EQ(one.non_finite.count, 0u);
        EXPECT_EQ(one.counts.rays, many.counts.rays);
    }
}

TEST(ShAmbient, ShootsNoRaysForASkyAndOnlyWhileItIsPreparedForProbes) {
    Scene scene = outside();
    const Outcome classic = baseline_of(scene);
    for (const Mode mode : {Mode::environment, Mode::probes, Mode::sampled}) {
        EXPECT_EQ(rendered(scene, with(mode)).counts.rays, classic.counts.rays);
    }
    const Outcome traced = rendered(scene, with(Mode::traced));
    EXPECT_GT(traced.counts.of(RayKind::gi), 64 * stage_of(traced, "ambient light").work);
}

TEST(ShAmbient, MakesNoPassWhereTheSkyIsBlackOrNothingAsks) {
    Scene scene = outside();
    scene.environment.reset();
    scene.settings.background = Rgb(0);
    Scene without = scene;
    without.settings.ambient_light = Rgb(0);
    const Outcome truth = baseline_of(without);
    for (const Mode mode : {Mode::environment, Mode::sampled}) {
        const Outcome outcome = rendered(scene, with(mode));
        EXPECT_FALSE(outcome.plan.needed("ambient light"));
        EXPECT_EQ(stage_of(outcome, "ambient light").work, 0u);
        EXPECT_EQ(different_pixels(outcome, truth), 0u);
    }
    scene.lights.clear();
    EXPECT_FALSE(rendered(scene, with(Mode::probes)).plan.needed("ambient light"));
    scene = outside();
    for (Material& material : scene.materials) material = Const{Rgb(1)};
    EXPECT_FALSE(rendered(scene, with(Mode::environment)).plan.needed("ambient light"));
}

TEST(ShAmbient, ProjectsASkyAndFillsProbesAnewOnlyWhenTheSceneChanges) {
    Scene scene = outside();
    scene.environment = slanted_sky();
    for (const auto& [mode, stage] :
         {std::pair(Mode::environment, "projection"), std::pair(Mode::probes, "probes")}) {
        const std::unique_ptr<Technique> technique = make(reference(), with(mode));
        const OwnStudio studio(scene);
        EXPECT_GT(stage_of(studio.render(*technique), stage).work, 0u);
        EXPECT_EQ(stage_of(studio.render(*technique), stage).work, 0u);
        EXPECT_EQ(stage_of(OwnStudio(scene).render(*technique), stage).work, 0u)
            << "the same scene elsewhere in memory";
        Scene other = scene;
        std::get<CubemapEnvironment>(*other.environment).sides[3](1, 0).z = 0.25f;
        EXPECT_GT(stage_of(OwnStudio(other).render(*technique), stage).work, 0u);
        EXPECT_GT(stage_of(studio.render(*technique), stage).work, 0u);
    }
}

TEST(ShAmbient, FillsProbesAnewWhenAnythingThatLightMeetsChanges) {
    const Scene scene = outside();
    const std::unique_ptr<Technique> technique = make(reference(), with(Mode::probes));
    const auto filled = [&](const Scene& changed) {
        return stage_of(OwnStudio(changed).render(*technique), "probes").work > 0;
    };
    EXPECT_TRUE(filled(scene));
    const std::array<std::function<void(Scene&)>, 5> changes{
        [](Scene& s) { s.lights.pop_back(); },
        [](Scene& s) { std::get<Lambert>(s.materials[3]).color.y *= 0.5f; },
        [](Scene& s) { s.nodes[5].to_world.offset.y += 0.5; },
        [](Scene& s) { std::get<Sphere>(s.geometries[0]).radius *= 1.5; },
        [](Scene& s) { s.settings.max_depth = 3; }};
    for (const auto& change : changes) {
        Scene other = scene;
        change(other);
        EXPECT_TRUE(filled(other));
        EXPECT_TRUE(filled(scene));
    }
    Scene moved = scene;
    moved.camera.position.x += 1;
    EXPECT_FALSE(filled(moved));
    set_param(*technique, "rays=33");
    EXPECT_TRUE(filled(scene));
}

TEST(ShAmbient, CountsPointsBelowZeroAndHasNoneWhereRingingIsMended) {
    Scene scene = outside();
    CubemapEnvironment sky;
    for (Image<Rgb>& side : sky.sides) side = Image<Rgb>({9, 9}, Rgb(0));
    sky.sides[CubemapEnvironment::pos_y](4, 4) = Rgb(100);
    scene.environment = sky;
    for (const auto& [ringing, some] :
         {std::pair(Ringing::off, true), {Ringing::least, false}, {Ringing::scaled, false}}) {
        Params params = with(Mode::environment);
        params.ringing = static_cast<int>(ringing);
        const Outcome outcome = rendered(scene, params);
        EXPECT_EQ(stage_of(outcome, "ringing").work > 0, some);
        bool below = false;
        for (const Rgb& e : testing::plane_of<Rgb>(outcome, "irradiance").pixels())
            below |= e.x < 0;
        EXPECT_EQ(below, some) << "never clamped in silence";
    }
}

TEST(ShAmbient, ShowsItsProbesInPlanesAndMarks) {
    const Outcome outcome = rendered(outside(), with(Mode::probes));
    EXPECT_GT(outcome.frame.marks.size(), 10u);
    const auto& irradiance = testing::plane_of<Rgb>(outcome, "irradiance");
    const auto& weight = testing::plane_of<float>(outcome, "probe weight");
    const auto& probe = testing::plane_of<std::uint32_t>(outcome, "probe");
    std::size_t seen = 0;
    for (std::size_t i = 0; i < weight.pixels().size(); ++i) {
        EXPECT_EQ(weight.pixels()[i] == 0, probe.pixels()[i] == ~std::uint32_t{0});
        if (weight.pixels()[i] == 0) continue;
        ++seen;
        EXPECT_GE(weight.pixels()[i], 0.125f - 1e-6f) << "the heaviest of eight";
        EXPECT_GT(irradiance.pixels()[i].z, 0);
    }
    EXPECT_GT(seen, 100u);
}

/// The classic tracer's lights send what a path tracer's do, times π.
Scene with_lights_for_paths(Scene scene) {
    for (Light& light : scene.lights) {
        std::get<PointLight>(light).power *= std::numbers::pi_v<float>;
    }
    return scene;
}

TEST(Traced, AgreesWithThePathTracer) {
    // A box with a lamp in it and an opening to the sky.
    Scene scene = testing::empty_scene();
    scene.settings.max_depth = 2;
    scene.environment = slanted_sky();
    scene.lights = {PointLight{.position = {0.3, 0.5, 0}, .power = 1}};
    testing::add_shape(scene, Plane{.y = -1, .limit = 3}, {}, Rgb(0.7f, 0.5f, 0.3f));
    testing::add_shape(scene, Sphere{.centre = {2, 0, 1}}, {}, Rgb(0.9f));
    testing::add_shape(scene, Cube{.centre = {-2, 0, 0}, .side = 1.5}, {}, Rgb(0.2f, 0.9f, 0.5f));
    const OwnStudio studio(scene), paths(with_lights_for_paths(scene));
    const PathLights lights(paths.scene());
    Tracer tracer(studio.studio().accelerator), other(paths.studio().accelerator);
    for (const Vec3d& way : {Vec3d(0, -1, 0), Vec3d(1, -0.2, 0.4), Vec3d(-1, 0.1, 0)}) {
        const Ray ray{{0, 0.2, 0}, glm::normalize(way)};
        const Surface surface = surface_at(scene, ray, tracer.closest(RayKind::primary, ray));
        // As many surfaces as a path has that leaves the point.
        const Rgb mean = Incoming(scene, Needs(), tracer, 3).mean_at(surface, 8192, Key(1));
        PathTracer path(paths.scene(), lights, {.depth = 2}, Needs(), other);
        Vec3d sum(0);
        constexpr std::uint32_t count = 32768;
        for (std::uint32_t i = 0; i < count; ++i) {
            const Draw draw{Key(2), i};
            const Ray away = leaving(surface, sample_cosine(surface.normal, spread(Key(3), i)));
            sum += path.radiance(away, draw);
        }
        const Vec3d expected = sum / double(count);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], expected[c], 0.01 * expected[c]) << c;
    }
}

}  // namespace
}  // namespace luch::techniques::sh_ambient
