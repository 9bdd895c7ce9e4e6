#include "framework/technique/catalogue.h"

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
    for (const Rgb& pixel : outcome.frame.colour.pixels()) {
        ASSERT_EQ(pixel, scene.settings.background);
    }
}

TEST_P(Conformance, LosesNoBitByLeavingOutWhatIsExact) {
    const Outcome planned = rendered(testing::bit_of_everything());
    const Outcome forced = rendered(testing::bit_of_everything(), 2, {.skip = false});
    EXPECT_EQ(planned.frame.colour, forced.frame.colour);
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
