#include "framework/technique/catalogue.h"

#include "framework/technique/stereo.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

// What every technique of the catalogue must do, a homework too.
namespace luch {
namespace {

class Conformance : public ::testing::TestWithParam<std::string_view> {
 protected:
    /// A frame with one sample a pixel, by a technique of its own.
    static Outcome rendered(Scene scene, int threads = 2, const Budget& budget = {}) {
        const testing::OwnStudio studio(std::move(scene), threads);
        const auto technique = find_technique(GetParam()).create();
        return studio.render(*technique, budget);
    }
    static Scene sized(Scene scene, Size size) {
        scene.settings.frame = size;
        return scene;
    }
};

TEST_P(Conformance, IsBitIdenticalOnOneTwoAndSixteenThreads) {
    const Outcome one = rendered(testing::bit_of_everything(), 1);
    for (const int threads : {2, 16}) {
        const Outcome many = rendered(testing::bit_of_everything(), threads);
        EXPECT_EQ(many.frame.colour, one.frame.colour) << threads;
        EXPECT_EQ(many.counts.rays, one.counts.rays) << threads;
        EXPECT_EQ(many.counts.object_tests, one.counts.object_tests) << threads;
    }
}

TEST_P(Conformance, IsFiniteForFramesOfAnyShape) {
    for (const Size size : {Size{1, 1}, Size{1, 23}, Size{641, 7}}) {
        const Outcome outcome = rendered(sized(testing::bit_of_everything(), size));
        EXPECT_EQ(outcome.frame.size(), size);
        EXPECT_EQ(outcome.non_finite.count, 0u);
    }
}

TEST_P(Conformance, ShowsTheSkyOfAnEmptyScene) {
    Scene scene = testing::empty_scene();
    scene.settings.background = {0.25f, 0.5f, 0.75f};
    const Outcome outcome = rendered(scene);
    const float resolution = find_technique(GetParam()).resolution;
    for (const Rgb& pixel : outcome.frame.colour.pixels()) {
        ASSERT_LE(max_norm(pixel - scene.settings.background), resolution);
    }
}

TEST_P(Conformance, LosesNoBitByLeavingOutWhatIsExact) {
    const Outcome planned = rendered(testing::bit_of_everything());
    const Outcome forced = rendered(testing::bit_of_everything(), 2, {.skip = false});
    EXPECT_EQ(planned.frame.colour, forced.frame.colour);
}

TEST_P(Conformance, LosesNoBitWhereNobodyLooksAtItsPlanes) {
    const Outcome shown = rendered(testing::bit_of_everything());
    const Outcome unseen = rendered(testing::bit_of_everything(), 2, {.planes = false});
    EXPECT_EQ(unseen.frame.colour, shown.frame.colour);
    EXPECT_EQ(unseen.counts.rays, shown.counts.rays);
}

TEST_P(Conformance, KeepsNothingBetweenFramesAndInstances) {
    const testing::OwnStudio studio(testing::bit_of_everything());
    const testing::OwnStudio other(testing::sixty_spheres());
    const auto first = find_technique(GetParam()).create(),
               second = find_technique(GetParam()).create();
    const Image<Rgb> fresh = studio.render(*first).frame.colour;
    static_cast<void>(other.render(*first));
    static_cast<void>(other.render(*second));
    EXPECT_EQ(studio.render(*first).frame.colour, fresh);
    EXPECT_EQ(studio.render(*second).frame.colour, fresh);
}

TEST_P(Conformance, SeesInStereoWhatItSeesWithEitherEye) {
    Scene scene = testing::bit_of_everything();
    scene.camera.stereo_separation = 0.5;
    const Camera camera = scene.camera;
    const testing::OwnStudio studio(std::move(scene));
    const auto technique = find_technique(GetParam()).create();
    const auto seen_by = [&](const Camera& eye) {
        Shot shot = shot_of(studio.scene());
        shot.spp = 1;
        shot.camera = eye;
        return studio.render(*technique, shot);
    };
    const Outcome both = seen_by(camera);
    if (!both.plan.applies) GTEST_SKIP() << both.plan.why;
    const Outcome left = seen_by(camera.left_eye()), right = seen_by(camera.right_eye());
    EXPECT_NE(left.frame.colour, right.frame.colour);
    for (std::size_t i = 0; i < both.frame.colour.pixels().size(); ++i) {
        ASSERT_EQ(both.frame.colour.pixels()[i],
                  anaglyph(left.frame.colour.pixels()[i], right.frame.colour.pixels()[i]));
    }
    EXPECT_EQ(both.counts.all_rays(), left.counts.all_rays() + right.counts.all_rays());
    EXPECT_EQ(both.counts.object_tests, left.counts.object_tests + right.counts.object_tests);
}

TEST_P(Conformance, ShowsEveryKindOfCameraOrSaysWhyNot) {
    for (const Projection projection :
         {Projection::fisheye, Projection::spherical, Projection::orthographic}) {
        Scene scene = testing::bit_of_everything();
        scene.camera.projection = projection;
        scene.camera.width = 20;
        const testing::OwnStudio studio(std::move(scene));
        const Outcome outcome = studio.render(*find_technique(GetParam()).create());
        if (!outcome.plan.applies) {
            EXPECT_NE(outcome.plan.why, "");
            continue;
        }
        EXPECT_EQ(outcome.non_finite.count, 0u);
        const bool black_corner = outcome.frame.colour(0, 0) == Rgb(0);
        EXPECT_EQ(black_corner, projection == Projection::fisheye);
    }
}

TEST_P(Conformance, MakesTheSamePictureWhileOnePixelsRaysAreRecorded) {
    const testing::OwnStudio studio(testing::bit_of_everything());
    const auto technique = find_technique(GetParam()).create();
    Shot shot = shot_of(studio.scene());
    shot.spp = 1;
    const Outcome plain = studio.render(*technique, shot);
    RayLog log;
    const Outcome watched = run(*technique, studio.studio(), shot, {}, {.warm_up = 0, .frames = 1},
                                nullptr, Watch{21, 30, &log});
    EXPECT_EQ(watched.frame.colour, plain.frame.colour);
    EXPECT_EQ(watched.counts.rays, plain.counts.rays);
    ASSERT_FALSE(log.rays().empty());
    const Ray through = Screen(shot.camera, shot.size).ray(21.5, 30.5);
    EXPECT_EQ(log.rays()[0].kind, RayKind::primary);
    EXPECT_EQ(log.rays()[0].ray.direction, through.direction);
}

std::vector<std::string_view> names() {
    std::vector<std::string_view> names;
    for (const TechniqueInfo& info : catalogue()) names.push_back(info.name);
    return names;
}

std::string test_name(const ::testing::TestParamInfo<std::string_view>& info) {
    std::string name(info.param);
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Conformance, ::testing::ValuesIn(names()), test_name);

}  // namespace
}  // namespace luch
