// The technique against closed forms and the thin lens.
#include "techniques/layered/layered.h"

#include "framework/technique/catalogue.h"
#include "framework/technique/run.h"
#include "tests/testing/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch::techniques::layered {
namespace {

using testing::OwnStudio;
using testing::plane_of;

std::unique_ptr<Technique> layered(const std::vector<std::string>& params = {}) {
    std::unique_ptr<Technique> technique = make(reference(), Mode::lens);
    for (const std::string& param : params) set_param(*technique, param);
    return technique;
}

Outcome rendered(const OwnStudio& studio, const std::vector<std::string>& params = {}) {
    return studio.render(*layered(params));
}

/// Through a thin lens, with rays.
Outcome truth_of(const OwnStudio& studio, int samples) {
    Shot shot = shot_of(studio.scene());
    shot.spp = samples;
    return studio.render(*baseline::describe().create(), shot);
}

/// A lens of 10 px at infinity, in focus at 10; 120 × 90 pixels, 108 a unit at distance 1.
Scene with_lens() {
    Scene scene = testing::empty_scene();
    scene.settings.frame = {120, 90};
    scene.camera.depth_of_field = true;
    scene.camera.focal_distance = 10;
    const double px_per_unit = lens_of(scene.camera, scene.settings.frame).px_per_unit;
    scene.camera.f_number = 5 * px_per_unit / (10 * scene.camera.focal_distance);
    return scene;
}

/// A box of one colour, unlit, from `low` to `high`.
void add_box(Scene& scene, const Vec3d& low, const Vec3d& high, const Rgb& colour) {
    scene.geometries.emplace_back(Cube{});
    scene.materials.emplace_back(Const{colour});
    add_node(scene, "", static_cast<GeometryId>(scene.geometries.size() - 1),
             static_cast<MaterialId>(scene.materials.size() - 1),
             Transform::scaling(high - low).then(Transform::translation((low + high) / 2.0)));
}

double segment(double t) {
    if (std::abs(t) >= 1) return t < 0 ? 1 : 0;
    return (std::acos(t) - t * std::sqrt(1 - t * t)) / std::numbers::pi;
}

/// The column that a plane x = 0 at any depth is seen in, from the middle of the frame.
constexpr int middle = 60;

class EachMode : public ::testing::TestWithParam<const char*> {
 protected:
    [[nodiscard]] std::vector<std::string> mode(std::vector<std::string> params = {}) const {
        params.push_back(std::string("mode=") + GetParam());
        params.emplace_back("samples=400");
        return params;
    }
};

TEST_P(EachMode, MakesACircularSegmentOfAHalfPlaneInFront) {
    Scene scene = with_lens();
    add_box(scene, {0, -90, 5}, {90, 90, 5.001}, {1, 0.2f, 0});
    add_box(scene, {-90, -90, 10}, {90, 90, 10.001}, {0, 0.2f, 1});
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio, mode());
    for (int x = 45; x < 75; ++x) {
        const double in_front = segment((middle - (x + 0.5)) / 5);
        EXPECT_NEAR(outcome.frame.colour(x, 45).r, in_front, 0.06) << x;
        EXPECT_NEAR(outcome.frame.colour(x, 45).b, 1 - in_front, 0.06) << x;
        EXPECT_NEAR(outcome.frame.colour(x, 45).g, 0.2, 1e-5) << "nothing is lost";
    }
}

TEST_P(EachMode, MakesADiscOfEqualEnergyOfAPoint) {
    Scene scene = with_lens();
    const double unit = 40 / lens_of(scene.camera, scene.settings.frame).px_per_unit;
    add_box(scene, {-2 * unit, -2 * unit, 40}, {2 * unit, 2 * unit, 40.01}, Rgb(100));
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio, mode());
    // |1/40 − 1/10| is ¾ of 1/10: 7.5 px; and the box itself is 4 px wide.
    double energy = 0;
    int covered = 0;
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 120; ++x) {
            const double off = std::hypot(x + 0.5 - 60, y + 0.5 - 45);
            energy += outcome.frame.colour(x, y).r;
            covered += outcome.frame.colour(x, y).r > 0 ? 1 : 0;
            if (off <= 3.75 + 2 * std::numbers::sqrt2 + 0.5) continue;
            EXPECT_EQ(outcome.frame.colour(x, y).r, 0) << x << " " << y;
        }
    }
    EXPECT_NEAR(energy, 1600, 16);
    EXPECT_GT(covered, 50);
}

TEST_P(EachMode, HasNoHaloOfABlurredBackgroundAroundASharpForeground) {
    Scene scene = with_lens();
    add_box(scene, {0, -90, 10}, {90, 90, 10.001}, {0, 1, 0});
    add_box(scene, {-900, -900, 100}, {900, 900, 101}, {1, 0, 0});
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio, mode());
    for (int x = middle + 1; x < 120; ++x) {
        EXPECT_EQ(outcome.frame.colour(x, 45), Rgb(0, 1, 0)) << x;
    }
    for (int x = 0; x < middle - 1; ++x) {
        EXPECT_NEAR(outcome.frame.colour(x, 45).r, 1, 1e-5) << x;
        EXPECT_NEAR(outcome.frame.colour(x, 45).g, 0, 1e-5) << "nor does the foreground spread";
    }
}

INSTANTIATE_TEST_SUITE_P(Layered, EachMode, ::testing::Values("lens", "discs"));

TEST(Layered, HasASharpForegroundOverABlurredBackgroundInTheLecturesCase) {
    Scene scene = with_lens();
    add_box(scene, {0, -90, 10}, {90, 90, 10.001}, {0, 1, 0});
    add_box(scene, {-900, -900, 100}, {0, 900, 101}, {1, 0, 0});
    add_box(scene, {0, -900, 100}, {900, 900, 101}, {0, 0, 1});
    scene.camera.position.x = -4;  // the edge behind shows beside the one in front
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio, {"mode=classic"});
    int mixed = 0;
    for (int x = 0; x < 120; ++x) {
        const Rgb& colour = outcome.frame.colour(x, 45);
        EXPECT_TRUE(colour.g == 0 || colour == Rgb(0, 1, 0)) << x;
        mixed += colour.r > 0.05f && colour.b > 0.05f ? 1 : 0;
    }
    EXPECT_GT(mixed, 4) << "red and blue run into each other";
}

TEST(Layered, SeesWhatIsBehindABlurredForegroundThoughItWasHidden) {
    Scene scene = with_lens();
    // A post 5 px wide before a white wall with a black strip as wide behind it.
    const double unit = 1 / lens_of(scene.camera, {120, 90}).px_per_unit;
    add_box(scene, {-2.5 * 5 * unit, -90, 5}, {2.5 * 5 * unit, 90, 5.001}, {1, 0, 0});
    add_box(scene, {-2 * 10 * unit, -90, 10}, {2 * 10 * unit, 90, 10.001}, {0, 0, 1});
    add_box(scene, {-90, -90, 10.01}, {90, 90, 10.02}, {0, 1, 0});
    const OwnStudio studio(std::move(scene));
    const Outcome outcome = rendered(studio, {"samples=400"});
    const Rgb centre = outcome.frame.colour(middle, 45);
    EXPECT_GT(centre.b, 0.3f) << "hidden in the sharp picture";
    EXPECT_GT(centre.r, 0.3f);
    EXPECT_LT(centre.g, 0.02f);
    EXPECT_GT(plane_of<std::uint8_t>(outcome, "behind")(middle, 45), 0);
}

double rmse(const Outcome& a, const Outcome& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.frame.colour.pixels().size(); ++i) {
        const Vec3d off = Vec3d(a.frame.colour.pixels()[i]) - Vec3d(b.frame.colour.pixels()[i]);
        sum += glm::dot(off, off);
    }
    return std::sqrt(sum / static_cast<double>(3 * a.frame.colour.pixels().size()));
}

/// Balls from before to behind the plane of focus, on a floor.
Scene row_of_balls() {
    Scene scene = with_lens();
    scene.settings.ambient_light = Rgb(0.3f);
    scene.lights[0] = PointLight{.position = {-4, 9, 0}, .power = 90};
    testing::add_shape(scene, Plane{.y = -1.5}, {}, {0.6f, 0.6f, 0.5f});
    for (int i = 0; i < 6; ++i) {
        const double z = 4 + 2.5 * i;
        testing::add_shape(scene, Sphere{.centre = {(i - 2) * 0.28 * z, -0.3, z}, .radius = 1.1},
                           {}, {i % 2 ? 0.8f : 0.1f, 0.4f, i % 3 ? 0.2f : 0.9f});
    }
    return scene;
}

TEST(Layered, ComesCloserToTheThinLensWithMoreLayersUntilItStays) {
    const OwnStudio studio(row_of_balls());
    const Outcome truth = truth_of(studio, 96);
    const auto error = [&](int layers) {
        return rmse(rendered(studio, {"layers=" + std::to_string(layers)}), truth);
    };
    const double two = error(2), eight = error(8), many = error(64), most = error(128);
    EXPECT_GT(two, 1.5 * eight);
    EXPECT_GT(eight, 1.2 * many);
    EXPECT_NEAR(many, most, 0.1 * many) << "the plateau";
    EXPECT_LT(most, 0.025);
    const Outcome sharp = rendered(studio, {"layers=1"});
    EXPECT_GT(rmse(sharp, truth), 2 * many);
}

TEST(Layered, KnowsWhatTheLensSeesInAlmostEveryPixel) {
    const OwnStudio studio(row_of_balls());
    const Outcome outcome = rendered(studio);
    double unknown = 0;
    const auto& shares = plane_of<float>(outcome, "unknown").pixels();
    for (const float share : shares) unknown += share;
    EXPECT_LT(unknown / static_cast<double>(shares.size()), 0.001);
}

TEST(Layered, ShootsTenTimesFewerRaysThanSixtyFourLensSamples) {
    const OwnStudio studio(row_of_balls());
    EXPECT_LT(10 * rendered(studio).counts.all_rays(), truth_of(studio, 64).counts.all_rays());
}

TEST(Layered, StaysFiniteWithAHighlightOf1e30) {
    Scene scene = row_of_balls();
    add_box(scene, {-2, 8, 40}, {2, 10, 41}, Rgb(1e30f));
    const OwnStudio studio(std::move(scene));
    for (const char* mode : {"mode=lens", "mode=discs", "mode=classic"}) {
        const Outcome outcome = rendered(studio, {mode});
        EXPECT_EQ(outcome.non_finite.count, 0u) << mode;
        for (const Rgb& pixel : outcome.frame.colour.pixels()) EXPECT_LE(pixel.r, 1.0001e30f);
    }
}

TEST(Layered, GivesTheSameBitsOnAnyNumberOfThreads) {
    const OwnStudio one(row_of_balls(), 1), three(row_of_balls(), 3);
    for (const char* mode : {"mode=lens", "mode=discs", "mode=classic"}) {
        const Outcome a = rendered(one, {mode}), b = rendered(three, {mode});
        EXPECT_EQ(a.frame.colour, b.frame.colour) << mode;
        EXPECT_EQ(plane_of<std::uint32_t>(a, "layers"), plane_of<std::uint32_t>(b, "layers"));
    }
}

TEST(Layered, ShowsItsLayersFromNearToFar) {
    Scene scene = with_lens();
    add_box(scene, {0, -90, 5}, {90, 90, 5.001}, Rgb(1));
    add_box(scene, {-90, -90, 20}, {90, 90, 21}, Rgb(1));
    const OwnStudio studio(std::move(scene));
    for (const char* mode : {"mode=lens", "mode=discs", "mode=classic"}) {
        const Outcome outcome = rendered(studio, {mode, "layers=2"});
        const auto& layers = plane_of<std::uint32_t>(outcome, "layers");
        EXPECT_EQ(layers(90, 45), 0u) << mode;
        EXPECT_EQ(layers(20, 45), 1u) << mode;
        EXPECT_NEAR(plane_of<float>(outcome, "depth")(90, 45), 5, 1e-4);
        EXPECT_NEAR(plane_of<float>(outcome, "circle of confusion")(90, 45), 10, 1e-3);
    }
}

/// A step that a student has still to write.
void no_disc(ImageView<const Rgba>, ImageView<const float>, Tile, ImageView<Rgba>) {
    LUCH_TODO("layered.t4");
}

TEST(Layered, FillsAHoleWithTheReferenceAndNamesIt) {
    Steps steps = reference();
    steps.disc = no_disc;
    const OwnStudio studio(row_of_balls());
    const Outcome outcome = studio.render(*make(steps));
    EXPECT_THAT(outcome.unwritten, ::testing::ElementsAre("layered.t4"));
    EXPECT_EQ(outcome.frame.colour, rendered(studio, {"mode=discs"}).frame.colour);
}

}  // namespace
}  // namespace luch::techniques::layered
