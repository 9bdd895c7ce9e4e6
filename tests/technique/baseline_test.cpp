#include "framework/baseline/classic.h"
#include "framework/technique/catalogue.h"
#include "tests/testing/everything.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch {
namespace {

Image<Rgb> rendered(Scene scene, int threads, int spp, std::uint64_t seed = 0,
                    const Budget& budget = {}) {
    const testing::OwnStudio studio(std::move(scene), threads);
    const auto technique = baseline::describe().create();
    Shot shot = shot_of(studio.scene());
    shot.spp = spp;
    shot.seed = seed;
    return studio.render(*technique, shot, budget).frame.colour;
}

Scene adaptive(Scene scene) {
    scene.settings.anti_aliasing = true;
    return scene;
}

TEST(Baseline, IsBitIdenticalOnOneTwoAndSixteenThreads) {
    for (const int spp : {0, 1, 3}) {
        const Scene scene = adaptive(testing::bit_of_everything());
        const Image<Rgb> one = rendered(scene, 1, spp);
        EXPECT_EQ(rendered(scene, 2, spp), one) << spp;
        EXPECT_EQ(rendered(scene, 16, spp), one) << spp;
    }
}

TEST(Baseline, IsBitIdenticalWithEveryExactStageForcedOn) {
    const Scene scene = testing::bit_of_everything();
    EXPECT_EQ(rendered(scene, 2, 1), rendered(scene, 2, 1, 0, {.skip = false}));
}

TEST(Baseline, ChangesWithTheSeedOnlyWhereItIsRandom) {
    const Scene scene = testing::bit_of_everything();
    EXPECT_EQ(rendered(scene, 2, 2, 1), rendered(scene, 2, 2, 1));
    EXPECT_NE(rendered(scene, 2, 2, 1), rendered(scene, 2, 2, 2));
    EXPECT_EQ(rendered(testing::sixty_spheres(), 2, 1, 1),
              rendered(testing::sixty_spheres(), 2, 1, 2));
}

TEST(Baseline, RendersFramesOfAnyShape) {
    for (const Size size : {Size{1, 1}, Size{1, 17}, Size{641, 7}}) {
        Scene scene = adaptive(testing::bit_of_everything());
        scene.settings.frame = size;
        const Image<Rgb> image = rendered(scene, 2, 0);
        EXPECT_EQ(image.size(), size);
        EXPECT_EQ(non_finite_pixels(image.view()).count, 0u);
    }
}

TEST(Antialias, SmoothsEdgesAndLeavesFlatPixelsAlone) {
    const Scene scene = testing::sixty_spheres();
    const Image<Rgb> plain = rendered(scene, 2, 1), smooth = rendered(adaptive(scene), 2, 0);
    int changed = 0;
    for (std::size_t i = 0; i < plain.pixels().size(); ++i) {
        changed += plain.pixels()[i] != smooth.pixels()[i] ? 1 : 0;
    }
    EXPECT_GT(changed, 200);
    EXPECT_LT(changed, static_cast<int>(plain.pixels().size()) / 2);
    EXPECT_EQ(plain(0, 0), smooth(0, 0));
}

}  // namespace
}  // namespace luch
