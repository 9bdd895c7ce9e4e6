#include "framework/image/io.h"
#include "framework/measure/metrics.h"
#include "framework/scene/loader/loader.h"
#include "framework/technique/catalogue.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

#include <filesystem>

// The course's own scenes, beside what its renderer makes of them; skipped where they are absent.
namespace luch {
namespace {

const std::filesystem::path folder = LUCH_SOURCE_DIR "/../shared/course-scenes";

/// The baseline's frame and the course's, as displayed.
struct Pair {
    Image<Rgb> ours, theirs;
};

Pair rendered(const std::string& name, int spp) {
    const testing::OwnStudio studio(load_scene(folder / (name + ".hexray"), {folder, false}).scene);
    Shot shot = shot_of(studio.scene());
    shot.spp = spp;
    const auto technique = find_technique("baseline").create();
    return {displayed(studio.render(*technique, shot).frame.colour.view()),
            read_displayed(folder / "peer" / (name + ".exr"))};
}

/// The mean of every block of 32 × 32 pixels: noise vanishes in it, a wrong light does not.
Image<Rgb> block_means(const Image<Rgb>& image) {
    constexpr int side = 32;
    Image<Rgb> means({image.width() / side, image.height() / side}, Rgb(0));
    for (int y = 0; y < means.height() * side; ++y) {
        for (int x = 0; x < means.width() * side; ++x) {
            means(x / side, y / side) += image(x, y) / float(side * side);
        }
    }
    return means;
}

TEST(CourseScenes, Lecture8IsTheCoursesPictureUpToNoise) {
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the course's scenes are not here";
    const auto [ours, theirs] = rendered("Lecture8", 16);
    EXPECT_LE(errors_between(theirs.view(), ours.view()).rmse, 0.012);
}

TEST(CourseScenes, BoxedHasTheCoursesLightInEveryPart) {
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the course's scenes are not here";
    const auto [ours, theirs] = rendered("boxed", 1);
    const Errors errors = errors_between(block_means(theirs).view(), block_means(ours).view());
    EXPECT_LE(errors.rmse, 0.006);
}

TEST(CourseScenes, HeightfieldHasTheCoursesIslandAndSea) {
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the course's scenes are not here";
    const auto [ours, theirs] = rendered("heightfield", 1);
    const Errors errors = errors_between(block_means(theirs).view(), block_means(ours).view());
    EXPECT_LE(errors.rmse, 0.006);
}

}  // namespace
}  // namespace luch
