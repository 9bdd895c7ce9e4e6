#include "framework/window/renderer.h"

#include "framework/base/error.h"
#include "tests/window/fakes.h"

#include <gtest/gtest.h>

namespace luch {
namespace {

using namespace std::chrono_literals;
using testing::endless;
using testing::eventually;
using testing::FakeStudio;
using testing::FakeTechnique;
using testing::painting;

RenderRequest request_for(Technique& technique, Size size = {40, 30}) {
    RenderRequest request;
    request.techniques = {{"fake", &technique}};
    request.shot.size = size;
    return request;
}

/// Waits for the result; nothing when none comes.
std::optional<RenderResult> result_of(Renderer& renderer) {
    renderer.wait(10s);
    return renderer.take();
}

TEST(Renderer, HandsOverEachResultOnce) {
    const FakeStudio fake;
    FakeTechnique red(painting({1, 0, 0}));
    Renderer renderer(fake.studio());
    renderer.start(request_for(red));
    const auto result = result_of(renderer);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->rendered.front().picture, (Image<Pixel>({40, 30}, {255, 0, 0})));
    EXPECT_FALSE(renderer.busy());
    EXPECT_FALSE(renderer.take());
}

TEST(Renderer, RendersAllTechniquesOfARequest) {
    const FakeStudio fake;
    FakeTechnique red(painting({1, 0, 0})), blue(painting({0, 0, 1}));
    Renderer renderer(fake.studio());
    RenderRequest request = request_for(red);
    request.techniques.push_back({"blue", &blue});
    renderer.start(request);
    const auto result = result_of(renderer);
    ASSERT_TRUE(result);
    ASSERT_EQ(result->rendered.size(), 2u);
    EXPECT_EQ(result->rendered[0].picture(0, 0), (Pixel{255, 0, 0}));
    EXPECT_EQ(result->rendered[1].picture(0, 0), (Pixel{0, 0, 255}));
}

TEST(Renderer, CancellingEndsAFrameThatNeverEnds) {
    const FakeStudio fake;
    std::atomic<bool> begun{false};
    FakeTechnique technique([&](const Shot& shot, Frame& frame, Context& context) {
        begun = true;
        endless()(shot, frame, context);
    });
    Renderer renderer(fake.studio());
    renderer.start(request_for(technique));
    ASSERT_TRUE(eventually([&] { return begun.load(); }));
    EXPECT_FALSE(renderer.wait(20ms));
    renderer.cancel();
    EXPECT_TRUE(renderer.wait(10s));
    EXPECT_FALSE(renderer.take()) << "half a frame was handed over";
}

TEST(Renderer, TheLatestRequestWins) {
    const FakeStudio fake;
    FakeTechnique slow(endless()), red(painting({1, 0, 0}));
    Renderer renderer(fake.studio());
    renderer.start(request_for(slow));
    for (int side = 1; side <= 20; ++side) renderer.start(request_for(red, {side, side}));
    const auto result = result_of(renderer);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->request.shot.size, (Size{20, 20}));
    EXPECT_FALSE(renderer.take());
}

TEST(Renderer, AnExceptionOnAWorkerArrivesOnceAndTheThreadsStayUsable) {
    const FakeStudio fake;
    FakeTechnique failing([](const Shot&, Frame& frame, Context& context) {
        context.for_each_tile(frame.size(), [](Tile, int) { throw Error("a texture is missing"); });
    });
    FakeTechnique red(painting({1, 0, 0}));
    Renderer renderer(fake.studio());
    renderer.start(request_for(failing));
    ASSERT_TRUE(renderer.wait(10s));
    try {
        renderer.take();
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "a texture is missing");
    }
    EXPECT_FALSE(renderer.take());
    renderer.start(request_for(red));
    EXPECT_TRUE(result_of(renderer));
}

TEST(Renderer, TheFailureOfWhatWasGivenUpIsNotHeard) {
    const FakeStudio fake;
    FakeTechnique failing([](const Shot&, Frame&, Context& context) {
        while (!context.cancelled()) std::this_thread::sleep_for(1ms);
        throw Error("too late");
    });
    FakeTechnique red(painting({1, 0, 0}));
    Renderer renderer(fake.studio());
    renderer.start(request_for(failing));
    std::this_thread::sleep_for(5ms);
    renderer.start(request_for(red));
    EXPECT_TRUE(result_of(renderer));
}

TEST(Renderer, TheFallbackStandsInForATechniqueThatDoesNotApply) {
    const FakeStudio fake;
    FakeTechnique declining(painting({1, 0, 0}), "the scene has no light");
    FakeTechnique blue(painting({0, 0, 1}));
    Renderer renderer(fake.studio());
    RenderRequest request = request_for(declining);
    request.fallback = &blue;
    renderer.start(request);
    const auto result = result_of(renderer);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->rendered.front().declined, "the scene has no light");
    EXPECT_EQ(result->rendered.front().picture(3, 3), (Pixel{0, 0, 255}));
}

TEST(Renderer, EndsWhileAFrameIsBeingMade) {
    const FakeStudio fake;
    FakeTechnique slow(endless());
    std::optional<Renderer> renderer(std::in_place, fake.studio());
    renderer->start(request_for(slow));
    std::this_thread::sleep_for(5ms);
    renderer.reset();
    SUCCEED() << "else the test would have hung until its time limit";
}

}  // namespace
}  // namespace luch
