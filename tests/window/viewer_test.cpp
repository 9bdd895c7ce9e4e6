#include "framework/window/viewer.h"

#include "framework/base/error.h"
#include "framework/image/io.h"
#include "framework/window/screenshot.h"
#include "tests/window/fakes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace luch {
namespace {

using namespace std::chrono_literals;
using testing::endless;
using testing::eventually;
using testing::FakeStudio;
using testing::FakeTechnique;
using testing::FakeWindow;
using ::testing::HasSubstr;
using testing::painting;

constexpr Pixel red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255};

/// A viewer in a make-believe window, with a clock that goes when it is told to.
class ViewerTest : public ::testing::Test {
 protected:
    ViewerTest() {
        setup.shot.camera = fake.scene.camera;
        setup.shot.size = {320, 240};
        setup.clock = [this] { return now; };
        setup.folder = ::testing::TempDir();
    }

    void add(const std::string& name, FakeTechnique::Render render, std::string declines = "") {
        setup.techniques.push_back(
            {name, std::make_unique<FakeTechnique>(std::move(render), std::move(declines))});
    }
    Viewer& open() {
        if (setup.techniques.empty()) add("green", painting({0, 1, 0}));
        return viewer.emplace(fake.studio(), std::move(setup), window, out);
    }
    void press(Command command) {
        window.next.commands = {command};
        viewer->turn(0);
    }
    /// Turns until the whole picture is there.
    bool settle() {
        return eventually([this] {
            viewer->turn(0);
            return viewer->settled();
        });
    }
    /// A pixel of the picture above the status and below the labels.
    Pixel pixel(int x = 10) { return viewer->picture()(x, 60); }

    FakeStudio fake;
    FakeWindow window{{320, 240}};
    std::ostringstream out;
    std::chrono::nanoseconds now{1'000'000'000'000'000'000};
    ViewerSetup setup;
    std::optional<Viewer> viewer;
};

TEST_F(ViewerTest, ShowsTheWholePicture) {
    open();
    ASSERT_TRUE(settle());
    EXPECT_EQ(window.shown, (Size{320, 240}));
    EXPECT_EQ(pixel(), green);
}

TEST_F(ViewerTest, DrawsNothingAnewWhileNothingHappens) {
    open();
    ASSERT_TRUE(settle());
    viewer->turn(0);
    const int shows = window.shows;
    for (int i = 0; i < 100; ++i) viewer->turn(0);
    EXPECT_EQ(window.shows, shows);
    window.next.exposed = true;
    viewer->turn(0);
    EXPECT_EQ(window.shows, shows + 1);
}

TEST_F(ViewerTest, TabShowsEveryTechniqueInTurnAndBack) {
    add("green", painting({0, 1, 0}));
    add("red", painting({1, 0, 0}));
    add("blue", painting({0, 0, 1}));
    open();
    std::vector<Pixel> seen;
    for (int i = 0; i < 4; ++i) {
        ASSERT_TRUE(settle());
        seen.push_back(pixel());
        press(Command::next_technique);
    }
    EXPECT_EQ(seen, (std::vector{green, red, blue, green}));
    EXPECT_EQ(viewer->technique(), "red");
    press(Command::previous_technique);
    press(Command::previous_technique);
    EXPECT_EQ(viewer->technique(), "blue");
}

TEST_F(ViewerTest, ATechniqueThatDoesNotApplyIsNotSkipped) {
    add("green", painting({0, 1, 0}));
    add("red", painting({1, 0, 0}), "the scene has no light");
    open();
    ASSERT_TRUE(settle());
    press(Command::next_technique);
    EXPECT_EQ(viewer->technique(), "red");
    ASSERT_TRUE(settle());
    EXPECT_EQ(pixel(), green) << "the baseline is to be shown";
}

TEST_F(ViewerTest, TheWiperFollowsTheMouse) {
    add("green", painting({0, 1, 0}));
    add("red", painting({1, 0, 0}));
    setup.shown = 1;
    open();
    ASSERT_TRUE(settle());
    press(Command::compare);
    ASSERT_TRUE(settle());
    window.next.mouse_x = 20;
    viewer->turn(0);
    EXPECT_EQ(pixel(19), red);
    EXPECT_EQ(pixel(21), green);
    press(Command::compare);
    ASSERT_TRUE(settle());
    EXPECT_EQ(pixel(21), red);
}

TEST_F(ViewerTest, FlightDependsOnTimeNotOnTheNumberOfTurns) {
    open();
    const auto fly = [&](int turns, bool FlyKeys::*key) {
        const Vec3d start = viewer->camera().position;
        for (int i = 0; i < turns; ++i) {
            now += 200ms / turns;
            window.next.keys.*key = true;
            viewer->turn(0);
        }
        return viewer->camera().position - start;
    };
    const Vec3d once = fly(1, &FlyKeys::forward);
    const Vec3d often = fly(50, &FlyKeys::forward);
    EXPECT_NEAR(once.z, 0.2 * flying_speed(fake.scene), 1e-12);
    EXPECT_LT(glm::distance(once, often), 1e-12);
    press(Command::home);
    EXPECT_EQ(viewer->camera().position, fake.scene.camera.position);
}

TEST_F(ViewerTest, TheCameraDoesNotLeapAfterAPause) {
    open();
    now += 24h;
    window.next.keys.forward = true;
    viewer->turn(0);
    EXPECT_LE(viewer->camera().position.z - fake.scene.camera.position.z,
              0.25 * flying_speed(fake.scene));
    now -= 48h;
    window.next.keys.forward = true;
    viewer->turn(0);
    EXPECT_GE(viewer->camera().position.z, fake.scene.camera.position.z);
}

TEST_F(ViewerTest, QuitsWhileAFrameIsBeingMade) {
    add("slow", endless());
    open();
    window.next.commands = {};
    viewer->turn(0);
    EXPECT_FALSE(viewer->settled());
    window.next.commands = {Command::quit};
    viewer->run();
    EXPECT_TRUE(viewer->rests(10s));
}

TEST_F(ViewerTest, AFailureIsShownAndEndsTheProgramOnlyWhenTheUserQuits) {
    add("green", painting({0, 1, 0}));
    add("failing", [](const Shot&, Frame&, Context&) { throw Error("a texture is missing"); });
    open();
    ASSERT_TRUE(settle());
    press(Command::next_technique);
    ASSERT_TRUE(settle());
    EXPECT_FALSE(viewer->done());
    const std::string said = out.str();
    EXPECT_THAT(said, HasSubstr("failing failed: a texture is missing"));
    for (int i = 0; i < 20; ++i) viewer->turn(0);
    EXPECT_EQ(out.str(), said) << "said more than once";
    press(Command::next_technique);
    ASSERT_TRUE(settle());
    EXPECT_EQ(pixel(), green);
    window.next.commands = {Command::quit};
    EXPECT_THROW(viewer->run(), Error);
}

TEST_F(ViewerTest, AFailureEndsARunOfSoManyFrames) {
    add("failing", [](const Shot&, Frame&, Context&) { throw Error("a texture is missing"); });
    setup.frames = 3;
    open();
    EXPECT_THROW(viewer->run(), Error);
}

TEST_F(ViewerTest, MakesAsManyFramesAsAsked) {
    int made = 0;
    add("counting", [&](const Shot& shot, Frame&, Context&) {
        EXPECT_EQ(shot.size, (Size{320, 240})) << "no previews";
        ++made;
    });
    setup.frames = 5;
    open();
    viewer->run();
    EXPECT_EQ(made, 5);
}

TEST_F(ViewerTest, TimesTheFrameAgainstTheOtherTechnique) {
    int made = 0;
    add("green", painting({0, 1, 0}));
    add("counting", [&](const Shot&, Frame&, Context&) { ++made; });
    setup.shown = 1;
    open();
    ASSERT_TRUE(settle());
    made = 0;
    press(Command::time);
    ASSERT_TRUE(settle());
    EXPECT_EQ(made, 8);  // a warm-up and seven
    EXPECT_THAT(out.str(), HasSubstr("timed: counting"));
    EXPECT_THAT(out.str(), HasSubstr("(median of 7)"));
    EXPECT_THAT(out.str(), HasSubstr("timed: green"));
    EXPECT_THAT(out.str(), HasSubstr("of the time of green"));
}

TEST_F(ViewerTest, CyclesThroughThePlanesOfTheFrame) {
    add("planes", [](const Shot&, Frame& frame, Context&) {
        for (Rgb& colour : frame.colour.pixels()) colour = {0, 1, 0};
        for (auto& mask : frame.plane<std::uint8_t>("mask", PlaneKind::mask).pixels()) mask = 1;
        for (Rgb& n : frame.plane<Rgb>("normals", PlaneKind::normal).pixels()) n = {1, -1, -1};
    });
    open();
    ASSERT_TRUE(settle());
    std::vector<Pixel> seen;
    for (int i = 0; i < 4; ++i) {
        seen.push_back(pixel());
        press(Command::next_plane);
    }
    EXPECT_EQ(seen, (std::vector{green, Pixel{255, 255, 255}, red, green}));
}

TEST_F(ViewerTest, MarksCanBeHidden) {
    add("marked", [](const Shot&, Frame& frame, Context&) {
        const float right = static_cast<float>(frame.size().width);
        const float bottom = static_cast<float>(frame.size().height);
        frame.marks = {{Mark::rectangle, 0, 0, right, bottom, {0, 0, 1}}};
    });
    open();
    ASSERT_TRUE(settle());
    EXPECT_EQ(pixel(0), blue);
    press(Command::marks);
    EXPECT_EQ(pixel(0), Pixel{});
}

TEST_F(ViewerTest, TheTextCanBeHidden) {
    open();
    ASSERT_TRUE(settle());
    EXPECT_NE(viewer->picture(), (Image<Pixel>({320, 240}, green)));
    press(Command::info);
    EXPECT_EQ(viewer->picture(), (Image<Pixel>({320, 240}, green)));
}

TEST_F(ViewerTest, AScreenshotIsTheWindowAndNeverOverwritesOne) {
    setup.folder = std::filesystem::path(::testing::TempDir()) /
                   ("luch_screenshots_" + std::to_string(::getpid()));
    std::filesystem::create_directories(setup.folder);
    std::ofstream(setup.folder / "luch-view-000.png") << "precious";
    const auto folder = setup.folder;
    open();
    ASSERT_TRUE(settle());
    press(Command::screenshot);
    press(Command::screenshot);
    std::ifstream precious(folder / "luch-view-000.png");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(precious), {}), "precious");
    EXPECT_THAT(out.str(), HasSubstr("luch-view-001.png"));
    EXPECT_THAT(out.str(), HasSubstr("luch-view-002.png"));
    const Picture saved = read_picture(folder / "luch-view-001.png");
    EXPECT_EQ(saved.pixels.size(), (Size{320, 240}));
    EXPECT_EQ(pixel_of(saved.pixels(10, 60)), green);
    std::filesystem::remove_all(folder);
}

TEST_F(ViewerTest, AFolderThatCannotBeWrittenToDoesNotEndTheViewer) {
    setup.folder = "/nowhere/at/all";
    open();
    ASSERT_TRUE(settle());
    press(Command::screenshot);
    EXPECT_FALSE(viewer->done());
    EXPECT_THAT(out.str(), HasSubstr("/nowhere/at/all"));
}

TEST_F(ViewerTest, SurvivesAThousandSizes) {
    open();
    for (int i = 0; i < 1000; ++i) {
        const Size sizes[] = {{0, 0}, {1, 1}, {640, 7}, {3, 480}, {i + 1, 1001 - i}};
        window.resize(sizes[i % 5]);
        window.next.exposed = true;
        viewer->turn(0);
    }
    window.resize({7680, 4320});
    ASSERT_TRUE(settle());
    EXPECT_EQ(window.shown, (Size{7680, 4320}));
    window.resize({320, 240});
    ASSERT_TRUE(settle());
    EXPECT_EQ(pixel(), green);
}

/// Pages of memory that the process holds; 0 where the system does not tell.
long resident_pages() {
    std::ifstream status("/proc/self/statm");
    long all = 0, resident = 0;
    status >> all >> resident;
    return resident;
}

TEST_F(ViewerTest, AMillionTurnsLaterNothingHasDriftedOrGrown) {
    open();
    ASSERT_TRUE(settle());
    const Camera before = viewer->camera();
    const Image<Pixel> picture = viewer->picture();
    long pages = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        now += 16'666'667ns;
        window.next.exposed = i % 100 == 0;
        viewer->turn(0);
        if (i == 1000) pages = resident_pages();
    }
    EXPECT_EQ(viewer->camera().position, before.position);
    EXPECT_EQ(viewer->camera().yaw_deg, before.yaw_deg);
    EXPECT_EQ(viewer->camera().pitch_deg, before.pitch_deg);
    EXPECT_EQ(viewer->picture(), picture);
    EXPECT_LE((resident_pages() - pages) * ::sysconf(_SC_PAGESIZE), 1 << 20);
}

TEST_F(ViewerTest, WorksInAWindowThatNobodySees) {
    const auto file = std::filesystem::path(::testing::TempDir()) /
                      ("luch_offscreen_" + std::to_string(::getpid()) + ".png");
    add("green", painting({0, 1, 0}));
    setup.frames = 3;
    setup.screenshot = file;
    const std::unique_ptr<Window> offscreen = open_window("a test", {320, 200}, true);
    EXPECT_EQ(offscreen->size(), (Size{320, 200}));
    Viewer seen(fake.studio(), std::move(setup), *offscreen, out);
    seen.run();
    const Picture saved = read_picture(file);
    EXPECT_EQ(saved.pixels.size(), (Size{320, 200}));
    EXPECT_EQ(pixel_of(saved.pixels(40, 60)), green);
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace luch
