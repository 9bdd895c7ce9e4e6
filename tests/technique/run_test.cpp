#include "framework/technique/run.h"

#include "framework/technique/context.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <limits>

namespace luch {
namespace {

/// Counts its frames, shoots a ray for each pixel and one from each worker's tracer, and paints one
/// pixel NaN.
class Fake final : public Technique {
 public:
    int frames = 0;
    bool applies = true;
    bool forced = false;

    Plan plan(const Scene&, const Shot&) const override {
        return {applies, "because", {{"extra", false, Stage::exact, "nothing needs it"}}};
    }
    void render(const Scene&, const Shot& shot, Frame& frame, Context& context) override {
        ++frames;
        forced = context.plan().needed("extra");
        context.for_each_tile(shot.size, [&](Tile tile, int worker) {
            const std::vector<Ray> rays(tile.area());
            std::vector<Hit> hits(tile.area());
            context.tracer(worker).closest(RayKind::gi, rays, hits);
        });
        for (int worker = 0; worker < context.workers(); ++worker) {
            static_cast<void>(context.tracer(worker).closest(RayKind::glossy, Ray{}));
        }
        context.did("extra", 40, "things");
        context.did("extra", 2, "things");
        context.did("no stage of the plan", 7, "");
        frame.colour(3, 2).g = std::numeric_limits<float>::quiet_NaN();
    }
};

TEST(Run, WarmsUpAndThenMakesTheFramesAskedFor) {
    const testing::OwnStudio studio(testing::empty_scene());
    Fake fake;
    const Outcome outcome = run(fake, studio.studio(), shot_of(studio.scene()), {}, {1, 7});
    EXPECT_EQ(fake.frames, 8);
    EXPECT_EQ(outcome.frame_ms.size(), 7u);
    EXPECT_EQ(outcome.cpu_ms.size(), 7u);
}

TEST(Run, WarmsUpBeforeASingleFrame) {
    const testing::OwnStudio studio(testing::empty_scene());
    Fake fake;
    const Outcome outcome = run(fake, studio.studio(), shot_of(studio.scene()), {}, {1, 1});
    EXPECT_EQ(fake.frames, 2);
    EXPECT_EQ(outcome.frame_ms.size(), 1u);
}

TEST(Run, TellsStagesWhatATechniqueCountedInOneFrame) {
    const testing::OwnStudio studio(testing::empty_scene());
    Fake fake;
    const Outcome outcome = run(fake, studio.studio(), shot_of(studio.scene()), {}, {1, 3});
    ASSERT_EQ(outcome.plan.stages.size(), 1u);
    EXPECT_EQ(outcome.plan.stages[0].work, 42u);
    EXPECT_EQ(outcome.plan.stages[0].worked_on, "things");
}

TEST(Run, CountsTheRaysOfOneFrameOverAllThreads) {
    for (const int threads : {1, 2, 16}) {
        const testing::OwnStudio studio(testing::empty_scene(), threads);
        Fake fake;
        const Outcome outcome = run(fake, studio.studio(), shot_of(studio.scene()), {}, {1, 3});
        EXPECT_EQ(outcome.counts.of(RayKind::gi), shot_of(studio.scene()).size.area());
        EXPECT_EQ(outcome.counts.of(RayKind::glossy), static_cast<std::uint64_t>(threads));
    }
}

TEST(Run, CountsPixelsThatAreNotFinite) {
    const testing::OwnStudio studio(testing::empty_scene());
    Fake fake;
    const Outcome outcome = studio.render(fake);
    EXPECT_EQ(outcome.non_finite.count, 1u);
    EXPECT_EQ(outcome.non_finite.first_x, 3);
    EXPECT_EQ(outcome.non_finite.first_y, 2);
}

TEST(Run, RendersNothingWhenThePlanDoesNotApply) {
    const testing::OwnStudio studio(testing::empty_scene());
    Fake fake;
    fake.applies = false;
    const Outcome outcome = studio.render(fake);
    EXPECT_EQ(fake.frames, 0);
    EXPECT_EQ(outcome.plan.why, "because");
    EXPECT_TRUE(outcome.frame_ms.empty());
}

TEST(Run, ForcesEveryStageOnWhenNothingMayBeSkipped) {
    const testing::OwnStudio studio(testing::empty_scene());
    Fake fake;
    static_cast<void>(studio.render(fake));
    EXPECT_FALSE(fake.forced);
    static_cast<void>(studio.render(fake, Budget{.skip = false}));
    EXPECT_TRUE(fake.forced);
}

TEST(Run, StopsWhenItIsCancelled) {
    const testing::OwnStudio studio(testing::empty_scene());
    CancelToken cancel;
    cancel.cancel();
    Fake fake;
    run(fake, studio.studio(), shot_of(studio.scene()), {}, {1, 7}, &cancel);
    EXPECT_EQ(fake.frames, 0);
}

TEST(Median, IsTheMiddleOrTheMeanOfTheMiddleTwo) {
    EXPECT_EQ(median({}), 0);
    EXPECT_EQ(median({3, 1, 2}), 2);
    EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
}

}  // namespace
}  // namespace luch
